// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/commit_log.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstddef>
#include <mutex>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/version.hpp"
#include "pliant/jobs/files/commit_words.hpp"

namespace pliant {
namespace {

constexpr std::uint64_t log_magic =
    0x4c43544e41494c50;  // "PLIANTCL" where the lowest byte is first
constexpr std::uint64_t bytes_of_word = sizeof(std::uint64_t);
constexpr std::uint64_t head_words = 2;

[[noreturn]] void fail_at(const std::filesystem::path& path) {
  const int error = errno;
  throw FileError(printable_name(path_text(path)) + ": " + error_words(error));
}

Descriptor open_log(const std::filesystem::path& path, Opening opening) {
  Descriptor file = open_file(path, opening);
  if (!file) fail_at(path);
  return file;
}

/// False at the end of the file, or where it is cut short.
bool read_words(const Descriptor& file, std::uint64_t at, std::span<std::uint64_t> words) {
  std::span<std::byte> left = std::as_writable_bytes(words);
  while (!left.empty()) {
    const std::ptrdiff_t count = read_at(file.get(), at, left);
    if (count <= 0) return false;
    left = left.subspan(static_cast<std::size_t>(count));
    at += static_cast<std::uint64_t>(count);
  }
  return true;
}

void add_bars_and_limits(const Framework& framework, CommitWords& words) {
  for (const Bar& bar : framework.bars()) {
    words.add(std::int64_t{bar.a});
    words.add(std::int64_t{bar.b});
  }
  for (const double length : framework.rest_lengths()) words.add(length);
  for (const double inverse : framework.inverse_masses()) words.add(inverse);
  for (const Limit& limit : framework.limits()) {
    words.add(std::int64_t{limit.a});
    words.add(std::int64_t{limit.b});
    for (const double number : {limit.least, limit.most, limit.energy}) words.add(number);
  }
}

void add_parameter(const Parameter& value, CommitWords& words) {
  std::visit(
      [&](const auto& one) {
        using T = std::decay_t<decltype(one)>;
        if constexpr (std::is_same_v<T, std::string>) {
          words.add(std::string_view(one));
        } else if constexpr (std::is_same_v<T, double>) {
          words.add(one);
        } else {
          words.add(static_cast<std::int64_t>(one));
        }
      },
      value);
}

}  // namespace

std::uint64_t key_of_run(const Framework& framework, std::span<const Vec3> start,
                         std::span<const NamedParameter> parameters) {
  CommitWords words;
  words.add(version());
  add_bars_and_limits(framework, words);
  words.add(start);
  for (const auto& [name, value] : parameters) {
    words.add(std::string_view(name));
    add_parameter(value, words);
  }
  return digest_of(words.words());
}

CommitLog::CommitLog(std::filesystem::path path, std::uint64_t key, Log log)
    : path_(std::move(path)), log_(std::move(log)) {
  is_there(path_) ? read(key) : begin(key);
}

void CommitLog::begin(std::uint64_t key) {
  const Descriptor file = open_log(path_, Opening::to_make);
  const std::array head{log_magic, key};
  if (!resize_file(file.get(), 0) || !write_all_at(file.get(), 0, std::as_bytes(std::span(head))))
    fail_at(path_);
  end_ = sizeof(head);
}

void CommitLog::read(std::uint64_t key) {
  const Descriptor file = open_log(path_, Opening::to_change);
  std::array<std::uint64_t, head_words> head{};
  if (!read_words(file, 0, head)) return begin(key);  // killed as soon as it was made
  if (head[0] != log_magic)
    throw InputError(printable_name(path_text(path_)) + ": is no log of commits");
  if (head[1] != key)
    throw InputError(printable_name(path_text(path_)) +
                     ": has the commits of another run: give another name, or remove it");
  end_ = sizeof(head);
  const std::uint64_t size = facts_of(file.get()).value_or(FileFacts{}).size;
  std::vector<std::uint64_t> words;
  while (read_words(file, end_, head)) {
    const std::uint64_t at = end_ + sizeof(head);
    if (head[0] > (size - at) / bytes_of_word) break;
    words.resize(head[0]);
    if (!read_words(file, at, words) || digest_of(words) != head[1]) break;
    if (!take(words, {at, head[0]})) break;
    end_ = at + head[0] * bytes_of_word;
  }
  if (!resize_file(file.get(), end_)) fail_at(path_);
}

/// False where the commit does not follow those before.
bool CommitLog::take(std::span<const std::uint64_t> words, Place place) {
  try {
    CommitWordReader reader(words);
    Walker& walker = walkers_[reader.integer()];
    const bool is_done = reader.integer() != 0;
    if (static_cast<std::size_t>(reader.integer()) != walker.reached.frames) return false;
    walker.reached.state = reader.state();
    walker.reached.frames += static_cast<std::size_t>(reader.integer());
    walker.reached.is_done = is_done;
    walker.places.push_back(place);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::optional<Committed> CommitLog::committed(std::int64_t walker) const {
  const auto found = walkers_.find(walker);
  if (found == walkers_.end() || found->second.places.empty()) return std::nullopt;
  return found->second.reached;
}

void CommitLog::replay(std::int64_t walker, const std::function<void(const Frame&)>& show) const {
  const auto found = walkers_.find(walker);
  if (found == walkers_.end()) return;
  const Descriptor file = open_log(path_, Opening::to_read);
  std::vector<std::uint64_t> words;
  for (const Place& place : found->second.places) {
    words.resize(place.words);
    errno = EIO;  // if it has become shorter
    if (!read_words(file, place.at, words)) fail_at(path_);
    CommitWordReader reader(words);
    for (int k = 0; k < 3; ++k) reader.integer();
    reader.state();
    std::vector<Vec3> positions;
    std::vector<std::uint8_t> limits_off;
    for (std::int64_t left = reader.integer(); left > 0; --left)
      show(reader.frame(positions, limits_off));
  }
}

void CommitLog::commit(std::int64_t walker, const KeptFrames& frames, std::size_t first,
                       const State& state, bool is_done, std::size_t before) {
  CommitWords words;
  words.add(walker);
  words.add(static_cast<std::int64_t>(is_done));
  words.add(static_cast<std::int64_t>(before + first));
  words.add(state);
  words.add(static_cast<std::int64_t>(frames.size() - first));
  for (std::size_t k = first; k < frames.size(); ++k) words.add(frames[k]);
  append(words.words());
}

/// Closed each time: then a network file system, too, has it.
void CommitLog::append(std::span<const std::uint64_t> words) {
  const std::lock_guard hold(writing_);
  if (is_gone_) return;
  const Descriptor file = open_file(path_, Opening::to_change);
  if (!file && errno == ENOENT) {
    is_gone_ = true;
    log_.warn(printable_name(path_text(path_)) +
              ": is gone, taken over by another process: the run goes on without commits");
    return;
  }
  const std::array head{std::uint64_t{words.size()}, digest_of(words)};
  if (!file || !write_all_at(file.get(), end_, std::as_bytes(std::span(head))) ||
      !write_all_at(file.get(), end_ + sizeof(head), std::as_bytes(words)))
    fail_at(path_);
  end_ += (head_words + words.size()) * bytes_of_word;
  ++commits_;
}

void CommitLog::remove() {
  const std::lock_guard hold(writing_);
  if (!is_gone_) remove_name(path_);
  is_gone_ = true;
}

}  // namespace pliant
