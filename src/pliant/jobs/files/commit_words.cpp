// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/commit_words.hpp"

#include <cstring>

#include "pliant/base/error.hpp"
#include "pliant/base/word_digest.hpp"

namespace pliant {
namespace {

constexpr std::size_t word_bytes = sizeof(std::uint64_t);

std::size_t words_for(std::size_t bytes) { return (bytes + word_bytes - 1) / word_bytes; }

static_assert(sizeof(Vec3) == 3 * word_bytes);

}  // namespace

void CommitWords::add(std::span<const Vec3> vectors) {
  add(static_cast<std::int64_t>(vectors.size()));
  for (const Vec3 v : vectors)
    for (const double x : {v.x, v.y, v.z}) add(x);
}

void CommitWords::add(std::span<const std::uint8_t> bytes) {
  add(static_cast<std::int64_t>(bytes.size()));
  const std::size_t before = words_.size();
  words_.resize(before + words_for(bytes.size()));
  if (!bytes.empty()) std::memcpy(words_.data() + before, bytes.data(), bytes.size());
}

void CommitWords::add(std::string_view text) {
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  add(std::span<const std::uint8_t>(bytes));
}

void CommitWords::add(const State& state) {
  add(state.step);
  add(state.time);
  add(std::span<const Vec3>(state.positions));
  add(std::span<const Vec3>(state.previous));
  add(std::span<const std::uint8_t>(state.limits_off));
}

void CommitWords::add(const Frame& frame) {
  for (const std::int64_t number :
       {frame.step, frame.sweeps, frame.projections, static_cast<std::int64_t>(frame.stop),
        frame.root_joint, frame.redraws, static_cast<std::int64_t>(frame.drawn_by), frame.walker})
    add(number);
  for (const double number : {frame.time, frame.max_residual, frame.rms_residual, frame.force.x,
                              frame.force.y, frame.force.z, frame.max_limit, frame.max_overlap})
    add(number);
  add(frame.positions);
  add(frame.limits_off);
}

std::uint64_t CommitWordReader::next() { return take(1)[0]; }

std::span<const std::uint64_t> CommitWordReader::take(std::size_t count) {
  if (count > words_.size()) throw InputError("a commit is shorter than it says");
  const auto taken = words_.first(count);
  words_ = words_.subspan(count);
  return taken;
}

std::vector<Vec3> CommitWordReader::vectors() {
  const auto count = static_cast<std::uint64_t>(integer());
  if (count > words_.size()) throw InputError("a commit is shorter than it says");
  std::vector<Vec3> vectors(count);
  for (Vec3& v : vectors) v = {real(), real(), real()};
  return vectors;
}

std::vector<std::uint8_t> CommitWordReader::bytes() {
  const auto count = static_cast<std::uint64_t>(integer());
  if (count > words_.size() * word_bytes) throw InputError("a commit is shorter than it says");
  const auto words = take(words_for(count));
  std::vector<std::uint8_t> bytes(count);
  if (count > 0) std::memcpy(bytes.data(), words.data(), count);
  return bytes;
}

State CommitWordReader::state() {
  State state;
  state.step = integer();
  state.time = real();
  state.positions = vectors();
  state.previous = vectors();
  state.limits_off = bytes();
  return state;
}

Frame CommitWordReader::frame(std::vector<Vec3>& positions, std::vector<std::uint8_t>& limits_off) {
  Frame frame;
  frame.step = integer();
  frame.sweeps = integer();
  frame.projections = integer();
  frame.stop = static_cast<Stop>(integer());
  frame.root_joint = integer();
  frame.redraws = integer();
  frame.drawn_by = static_cast<DrawnBy>(integer());
  frame.walker = integer();
  for (double* number : {&frame.time, &frame.max_residual, &frame.rms_residual, &frame.force.x,
                         &frame.force.y, &frame.force.z, &frame.max_limit, &frame.max_overlap})
    *number = real();
  frame.positions = positions = vectors();
  frame.limits_off = limits_off = bytes();
  return frame;
}

std::uint64_t digest_of(std::span<const std::uint64_t> words) {
  WordDigest digest;
  for (const std::uint64_t word : words) digest.add(word);
  return digest.value();
}

}  // namespace pliant
