// SPDX-License-Identifier: MIT
#include "pliant/text/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

// Locked bytes, where no file has data. The second tells who holds the first: only a traditional
// lock knows its process, but it does not hold between two recorders of one process.
constexpr off_t writer_byte = off_t{1} << 62;
constexpr off_t process_byte = writer_byte + 1;

struct Descriptor {
  int value;
  explicit Descriptor(int descriptor) : value(descriptor) {}
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

std::string shown(const fs::path& path) { return printable_name(path.string()); }

[[noreturn]] void fail_with(const fs::path& path, const std::string& what, int error) {
  throw FileError(shown(path) + ": " + what + ": " + std::strerror(error));
}

struct flock write_lock(off_t byte) {
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

enum class Locking { locked, held_by_another, has_no_locks };

Locking lock_for_writing(int descriptor) {
  struct flock writer = write_lock(writer_byte);
  if (::fcntl(descriptor, F_OFD_SETLK, &writer) != 0)
    return errno == EAGAIN || errno == EACCES ? Locking::held_by_another : Locking::has_no_locks;
  struct flock process = write_lock(process_byte);
  ::fcntl(descriptor, F_SETLK, &process);
  return Locking::locked;
}

bool is_being_written(int descriptor) {
  struct flock lock = write_lock(writer_byte);
  return ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

std::string holder_of(int descriptor) {
  struct flock lock = write_lock(process_byte);
  const bool is_known =
      ::fcntl(descriptor, F_GETLK, &lock) == 0 && lock.l_type != F_UNLCK && lock.l_pid > 0;
  return is_known ? "process " + std::to_string(lock.l_pid) : "another recorder";
}

[[noreturn]] void refuse_as_busy(const fs::path& path, int descriptor) {
  throw FileError(shown(path) + ": is being written by " + holder_of(descriptor));
}

void refuse_if_busy(const fs::path& path) {
  const Descriptor existing(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (existing.value >= 0 && is_being_written(existing.value)) refuse_as_busy(path, existing.value);
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
  return target.parent_path() / ("." + target.filename().string() + number + ".partial");
}

bool is_same_file(int descriptor, const fs::path& path) {
  struct stat opened {
  }, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
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
  descriptor_ = ::open(target_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (descriptor_ < 0) fail_with(target_, "cannot open it for writing", errno);
  try {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode))
      throw FileError(target_.string() + ": is not a regular file");
    if (lock_for_writing(descriptor_) == Locking::held_by_another)
      refuse_as_busy(target_, descriptor_);
  } catch (...) {
    close();
    throw;
  }
}

OutputFile::~OutputFile() { close(); }

/// What a killed writer has left behind is taken over: nobody holds its lock.
void OutputFile::create() {
  temporary_ = temporary_name(target_, "");
  for (;;) {
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ < 0)
      fail_with(target_, "cannot write to " + shown(target_.parent_path()), errno);
    const Locking locking = lock_for_writing(descriptor_);
    if (locking == Locking::has_no_locks) return create_apart();
    if (locking == Locking::held_by_another) {
      const Descriptor busy(std::exchange(descriptor_, -1));
      refuse_as_busy(target_, busy.value);
    }
    // It may have been published or deleted between the two calls.
    if (is_same_file(descriptor_, temporary_)) break;
    ::close(std::exchange(descriptor_, -1));
  }
  std::error_code error;
  if (fs::file_size(temporary_, error) > 0 && ::ftruncate(descriptor_, 0) != 0)
    fail_with(target_, "cannot write", errno);
}

/// Without locks each writer needs a name of its own.
void OutputFile::create_apart() {
  static std::atomic<unsigned> count = 0;
  ::close(std::exchange(descriptor_, -1));
  ::unlink(temporary_.c_str());
  temporary_ =
      temporary_name(target_, "." + std::to_string(::getpid()) + "-" + std::to_string(count++));
  ::unlink(temporary_.c_str());
  descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail_with(target_, "cannot write to " + shown(target_.parent_path()), errno);
}

void OutputFile::write(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail_with(target_, "cannot write", count < 0 ? errno : ENOSPC);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void OutputFile::publish() {
  // Another run may take or replace the name between two calls: look again.
  for (int attempt = 0; attempt < 100 && !published_; ++attempt)
    published_ = take_free_name() || replace_existing();
  if (!published_) fail_with(target_, "cannot take its name", EBUSY);
}

/// Returns false when the name is taken.
bool OutputFile::take_free_name() {
  if (::link(temporary_.c_str(), target_.c_str()) == 0) {
    ::unlink(temporary_.c_str());
    return true;
  }
  if (errno == EEXIST) return false;
  // A file system without hard links.
  std::error_code error;
  if (fs::exists(target_, error)) return false;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail_with(target_, "cannot rename " + shown(temporary_), errno);
  return true;
}

/// Returns false when the name has become free, or another file's.
bool OutputFile::replace_existing() {
  if (!overwrite_) refuse_existing(target_);
  const Descriptor existing(::open(target_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
  if (existing.value < 0 && errno == ENOENT) return false;
  if (existing.value < 0) fail_with(target_, "cannot replace it", errno);
  if (lock_for_writing(existing.value) == Locking::held_by_another)
    refuse_as_busy(target_, existing.value);
  if (!is_same_file(existing.value, target_)) return false;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail_with(target_, "cannot replace it", errno);
  return true;
}

void OutputFile::sync_name() const {
  const Descriptor folder(
      ::open(target_.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.value >= 0) ::fsync(folder.value);
}

void OutputFile::close() {
  if (descriptor_ < 0) return;
  if (!published_) ::unlink(temporary_.c_str());
  ::close(descriptor_);
  descriptor_ = -1;
}

std::string writer_of(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  return file.value >= 0 && is_being_written(file.value) ? holder_of(file.value) : "";
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
