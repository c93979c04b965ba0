// SPDX-License-Identifier: MIT
#include "pliant/text/output_file.hpp"

#include <atomic>
#include <cerrno>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/file_lock.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/system/process.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

std::string shown(const fs::path& path) { return printable_name(path_text(path)); }

[[noreturn]] void fail_with(const fs::path& path, const std::string& what, int error) {
  throw FileError(shown(path) + ": " + what + ": " + error_words(error));
}

[[noreturn]] void refuse_as_busy(const fs::path& path, int descriptor) {
  throw FileError(shown(path) + ": is being written by " + lock_holder(descriptor));
}

void refuse_if_busy(const fs::path& path) {
  const Descriptor existing = open_file(path, Opening::to_read);
  if (existing && is_being_written(existing.get())) refuse_as_busy(path, existing.get());
}

[[noreturn]] void refuse_existing(const fs::path& path) {
  refuse_if_busy(path);
  throw FileError(shown(path) + ": exists already; overwrite replaces it");
}

void check_directory(const fs::path& target) {
  const fs::path directory = target.parent_path();
  std::error_code error;
  const fs::file_status status = fs::status(directory, error);
  if (status.type() == fs::file_type::not_found)
    throw FileError(shown(target) + ": the directory " + shown(directory) + " does not exist");
  if (status.type() != fs::file_type::directory)
    throw FileError(shown(target) + ": " + shown(directory) + " is not a directory");
}

void check_target(const fs::path& target, bool overwrite) {
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (status.type() == fs::file_type::not_found) return;
  if (status.type() == fs::file_type::directory)
    throw FileError(shown(target) + ": is a directory");
  if (status.type() != fs::file_type::regular)
    throw FileError(shown(target) + ": is not a regular file");
  if (!overwrite) refuse_existing(target);
  refuse_if_busy(target);
}

fs::path resolved(const fs::path& target) {
  if (target.empty()) throw FileError("the name of the output file is empty");
  std::error_code error;
  fs::path found = fs::weakly_canonical(fs::absolute(target, error), error);
  if (error) fail_with(target, "cannot find it", error.value());
  check_directory(found);
  return found;
}

/// A hidden file beside the target. Without a number it is the same for all who write the target.
fs::path temporary_name(const fs::path& target, const std::string& number) {
  const std::string name = "." + path_text(target.filename()) + number + ".partial";
  return target.parent_path() / path_of(name);
}

}  // namespace

OutputFile::OutputFile(const fs::path& target, bool overwrite)
    : target_(resolved(target)), overwrite_(overwrite) {
  check_target(target_, overwrite_);
  try {
    create();
    check_target(target_, overwrite_);  // whoever held the lock until now may have taken the name
  } catch (...) {
    close();
    throw;
  }
}

OutputFile::OutputFile(const fs::path& existing)
    : target_(resolved(existing)), overwrite_(true), published_(true) {
  file_ = open_file(target_, Opening::to_change);
  if (!file_) fail_with(target_, "cannot open it for writing", errno);
  try {
    const std::optional<FileFacts> facts = facts_of(descriptor());
    if (!facts || facts->kind != FileKind::regular)
      throw FileError(shown(target_) + ": is not a regular file");
    if (lock_for_writing(descriptor()) == Locking::held_by_another)
      refuse_as_busy(target_, descriptor());
  } catch (...) {
    close();
    throw;
  }
}

OutputFile::~OutputFile() { close(); }

/// What a killed writer has left behind is taken over: nobody holds its lock.
void OutputFile::create() {
  temporary_ = partial_name(target_);
  for (;;) {
    open_temporary(Opening::to_make);
    const Locking locking = lock_for_writing(descriptor());
    if (locking == Locking::has_no_locks) return create_apart();
    if (locking == Locking::held_by_another) {
      const Descriptor busy = std::exchange(file_, {});
      refuse_as_busy(target_, busy.get());
    }
    // It may have been published or deleted between the two calls.
    if (is_same_file(descriptor(), temporary_)) break;
    file_.close();
  }
  const std::optional<FileFacts> facts = facts_of(descriptor());
  if (facts && facts->size > 0 && !resize_file(descriptor(), 0))
    fail_with(target_, "cannot write", errno);
}

void OutputFile::open_temporary(Opening opening) {
  file_ = open_file(temporary_, opening);
  if (!file_) fail_with(target_, "cannot write to " + shown(target_.parent_path()), errno);
}

/// Without locks each writer needs a name of its own.
void OutputFile::create_apart() {
  static std::atomic<unsigned> count = 0;
  file_.close();
  remove_name(temporary_);
  temporary_ =
      temporary_name(target_, "." + std::to_string(process_id()) + "-" + std::to_string(count++));
  remove_name(temporary_);
  open_temporary(Opening::to_make_anew);
}

void OutputFile::write(std::string_view text) const {
  if (!write_all(descriptor(), std::as_bytes(std::span(text))))
    fail_with(target_, "cannot write", errno);
}

void OutputFile::flush() const {
  if (!flush_contents(descriptor())) fail_with(target_, "cannot write", errno);
  lock_for_writing(descriptor());
}

void OutputFile::publish() {
  flush();
  // Another run may take or replace the name between two calls: look again.
  for (int attempt = 0; attempt < 100 && !published_; ++attempt)
    published_ = take_free_name() || replace_existing();
  if (!published_) fail_with(target_, "cannot take its name", EBUSY);
}

/// Returns false when the name is taken.
bool OutputFile::take_free_name() {
  if (take_name(temporary_, target_)) return true;
  if (errno != EEXIST) fail_with(target_, "cannot rename " + shown(temporary_), errno);
  return false;
}

/// Returns false when the name has become free, or another file's.
bool OutputFile::replace_existing() {
  if (!overwrite_) refuse_existing(target_);
  Descriptor existing = open_file(target_, Opening::to_change);
  if (!existing && errno == ENOENT) return false;
  if (!existing) fail_with(target_, "cannot replace it", errno);
  if (lock_for_writing(existing.get()) == Locking::held_by_another)
    refuse_as_busy(target_, existing.get());
  if (!is_same_file(existing.get(), target_)) return false;
  if (!replace_name(temporary_, target_, std::move(existing)))
    fail_with(target_, "cannot replace it", errno);
  return true;
}

void OutputFile::close() {
  if (!file_) return;
  if (!published_) remove_name(temporary_);
  file_.close();
}

fs::path partial_name(const fs::path& target) { return temporary_name(target, ""); }

std::string writer_of(const fs::path& path) {
  const Descriptor file = open_file(path, Opening::to_read);
  return file && is_being_written(file.get()) ? lock_holder(file.get()) : "";
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) fail_with(path, "cannot make the folder", error.value());
}

void write_text_file(const fs::path& path, std::string_view text, bool overwrite) {
  OutputFile file(path, overwrite);
  file.write(text);
  file.publish();
}

}  // namespace pliant
