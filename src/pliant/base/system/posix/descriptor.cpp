// SPDX-License-Identifier: MIT
#include "pliant/base/system/descriptor.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace pliant {
namespace {

using Status = struct stat;

constexpr int new_file_mode = 0666;  // without what the user's mask takes away

int flags_of(Opening opening) {
  switch (opening) {
    case Opening::to_read:
      return O_RDONLY | O_NONBLOCK;
    case Opening::to_change:
      return O_RDWR | O_NONBLOCK;
    case Opening::to_make:
      return O_RDWR | O_CREAT | O_NOFOLLOW;
    case Opening::to_make_anew:
      return O_RDWR | O_CREAT | O_EXCL;
  }
  return O_RDONLY;
}

FileKind kind_of(const Status& status) {
  if (S_ISREG(status.st_mode)) return FileKind::regular;
  if (S_ISDIR(status.st_mode)) return FileKind::folder;
  const bool is_device = S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode);
  return is_device ? FileKind::device : FileKind::stream;
}

/// Calls again what a signal has interrupted.
template <class Call>
auto uninterrupted(Call call) {
  for (;;) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

/// Calls `write` with what is left, until nothing is.
template <class Write>
bool write_whole(std::span<const std::byte> bytes, Write write) {
  while (!bytes.empty()) {
    const ssize_t count = uninterrupted([&] { return write(bytes); });
    if (count == 0) errno = ENOSPC;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

std::string error_words(int error) { return std::generic_category().message(error); }

void Descriptor::close() {
  if (number_ >= 0) ::close(std::exchange(number_, -1));
}

Descriptor open_file(const std::filesystem::path& path, Opening opening) {
  const int flags = flags_of(opening) | O_CLOEXEC;
  Descriptor file(uninterrupted([&] { return ::open(path.c_str(), flags, new_file_mode); }));
  // Opened without waiting; but what a pipe will bring is waited for, where somebody writes to it.
  if (file && opening == Opening::to_read) ::fcntl(file.get(), F_SETFL, 0);
  return file;
}

std::optional<FileFacts> facts_of(int descriptor) {
  Status status{};
  if (::fstat(descriptor, &status) != 0) return std::nullopt;
  const FileKind kind = kind_of(status);
  return FileFacts{kind, kind == FileKind::regular ? std::uint64_t(status.st_size) : 0};
}

bool is_there(const std::filesystem::path& path) {
  Status status{};
  return ::stat(path.c_str(), &status) == 0;
}

bool is_same_file(int descriptor, const std::filesystem::path& path) {
  Status opened{}, named{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

std::ptrdiff_t read_some(int descriptor, std::span<std::byte> bytes) {
  return uninterrupted([&] { return ::read(descriptor, bytes.data(), bytes.size()); });
}

std::ptrdiff_t read_at(int descriptor, std::uint64_t position, std::span<std::byte> bytes) {
  const auto offset = static_cast<off_t>(position);
  return uninterrupted([&] { return ::pread(descriptor, bytes.data(), bytes.size(), offset); });
}

bool write_all(int descriptor, std::span<const std::byte> bytes) {
  return write_whole(bytes, [&](std::span<const std::byte> left) {
    return ::write(descriptor, left.data(), left.size());
  });
}

bool write_all_at(int descriptor, std::uint64_t position, std::span<const std::byte> bytes) {
  return write_whole(bytes, [&](std::span<const std::byte> left) {
    const auto offset = static_cast<off_t>(position + (bytes.size() - left.size()));
    return ::pwrite(descriptor, left.data(), left.size(), offset);
  });
}

bool resize_file(int descriptor, std::uint64_t size) {
  return uninterrupted([&] { return ::ftruncate(descriptor, static_cast<off_t>(size)); }) == 0;
}

/// WebAssembly has no files to write, and no copies of descriptors.
bool flush_contents(int descriptor) {
#if defined(__wasi__)
  return descriptor >= 0;
#else
  const int copy = ::fcntl(descriptor, F_DUPFD_CLOEXEC, 0);
  return copy >= 0 && ::close(copy) == 0;
#endif
}

/// The lock that `held` may have lasts until the file has lost its name.
bool replace_name(const std::filesystem::path& from, const std::filesystem::path& to,
                  Descriptor /*held*/) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

bool take_name(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::link(from.c_str(), to.c_str()) == 0) {
    remove_name(from);
    return true;
  }
  if (errno == EEXIST) return false;
  if (is_there(to)) {
    errno = EEXIST;
    return false;
  }
  return replace_name(from, to);
}

void remove_name(const std::filesystem::path& path) { ::unlink(path.c_str()); }

}  // namespace pliant
