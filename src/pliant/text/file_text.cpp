// SPDX-License-Identifier: MIT
#include "pliant/text/file_text.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/text/compression.hpp"

namespace pliant {
namespace {

[[noreturn]] void fail_to_read(const std::string& name, std::string_view reason) {
  throw FileError("cannot read " + printable_name(name) + ": " + std::string(reason));
}

[[noreturn]] void fail_by_errno(const std::string& name) {
  fail_to_read(name, std::generic_category().message(errno));
}

/// An open file, closed with the object.
class OpenFile {
 public:
  explicit OpenFile(const std::string& name) : name_(name) {
    do descriptor_ = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
    while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0) fail_by_errno(name_);
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Size of a regular file, 0 for pipes; refuses what has no end.
  std::size_t expected_size() const {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0) fail_by_errno(name_);
    if (S_ISDIR(status.st_mode)) fail_to_read(name_, "Is a directory");
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode))
      fail_to_read(name_, "is a device, not a file");
    return S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  }

  /// Reads up to `count` bytes; 0 at the end.
  std::size_t read(char* into, std::size_t count) const {
    ssize_t got = 0;
    do got = ::read(descriptor_, into, count);
    while (got < 0 && errno == EINTR);
    if (got < 0) fail_by_errno(name_);
    return static_cast<std::size_t>(got);
  }

 private:
  std::string name_;
  int descriptor_ = -1;
};

void check_size(std::size_t size, const std::string& name, std::size_t most) {
  if (size > most)
    throw TooLargeError(
        at({name}, "is larger than " + megabytes(most) + ", the most that is read"));
}

std::string read_raw(const std::string& name, std::size_t most) {
  const OpenFile file(name);
  const std::size_t expected = file.expected_size();
  check_size(expected, name, most);
  std::string bytes;
  bytes.reserve(expected + 1);
  for (std::size_t size = 0;;) {
    const std::size_t room = std::max<std::size_t>(bytes.capacity() - size, 1 << 16);
    bytes.resize(size + room);
    const std::size_t got = file.read(bytes.data() + size, room);
    bytes.resize(size += got);
    if (got == 0) return bytes;
    check_size(size, name, most);
  }
}

/// Bytes that no text holds: NUL and control characters, but tab, line ends, form feed, and the
/// end-of-file mark of DOS.
constexpr bool is_binary(unsigned char c) { return c < 9 || (c >= 14 && c < 32 && c != 26); }

std::string hex(unsigned char c) {
  constexpr char digits[] = "0123456789abcdef";
  return {'0', 'x', digits[c >> 4], digits[c & 15]};
}

void refuse_wide_encodings(const SourceText& source) {
  using namespace std::string_view_literals;
  const std::string_view head = source.text.substr(0, 4);
  if (head == "\xff\xfe\0\0"sv || head == "\0\0\xfe\xff"sv)
    fail({source.name}, "is UTF-32 text: save it as UTF-8 or ASCII");
  const bool marked = head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff");
  const bool every_second =
      head.size() == 4 && ((head[0] != 0 && head[1] == 0 && head[2] != 0 && head[3] == 0) ||
                           (head[0] == 0 && head[1] != 0 && head[2] == 0 && head[3] != 0));
  if (marked || every_second) fail({source.name}, "is UTF-16 text: save it as UTF-8 or ASCII");
}

}  // namespace

std::string read_bytes(const std::filesystem::path& path, std::size_t most) {
  const std::string name = path.string();
  std::string bytes = read_raw(name, most);
  if (const Compression* compression = compression_of(bytes))
    return expand(*compression, bytes, name, most);
  return bytes;
}

bool is_there(const std::filesystem::path& path) {
  struct stat status {};
  return ::stat(path.string().c_str(), &status) == 0;
}

std::string megabytes(std::size_t bytes) {
  constexpr std::size_t one = 1000000;
  const bool is_whole = bytes >= one && bytes % one == 0;
  return is_whole ? std::to_string(bytes / one) + " MB" : std::to_string(bytes) + " bytes";
}

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

void check_text(const SourceText& source) {
  if (source.text.empty()) fail({source.name}, "is empty");
  refuse_wide_encodings(source);
  // Summing over blocks lets the compiler look at many bytes at once.
  constexpr std::size_t block = 1 << 12;
  for (std::size_t start = 0; start < source.text.size(); start += block) {
    const std::string_view part = source.text.substr(start, block);
    unsigned bad = 0;
    for (char c : part) bad += is_binary(static_cast<unsigned char>(c));
    if (bad == 0) continue;
    const auto at = std::find_if(part.begin(), part.end(),
                                 [](char c) { return is_binary(static_cast<unsigned char>(c)); });
    const auto before = source.text.substr(0, start + static_cast<std::size_t>(at - part.begin()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    fail({source.name, static_cast<std::size_t>(line)},
         "holds the byte " + hex(static_cast<unsigned char>(*at)) +
             ": a binary file, not a molecule in text");
  }
}

}  // namespace pliant
