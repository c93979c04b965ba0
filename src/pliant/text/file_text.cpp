// SPDX-License-Identifier: MIT
#include "pliant/text/file_text.hpp"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <span>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/text/compression.hpp"

namespace pliant {
namespace {

[[noreturn]] void fail_to_read(const std::string& name, std::string_view reason) {
  throw FileError("cannot read " + printable_name(name) + ": " + std::string(reason));
}

[[noreturn]] void fail_by_errno(const std::string& name) { fail_to_read(name, error_words(errno)); }

/// Facts of a file or a pipe; refuses what has no end.
FileFacts expected_facts(int descriptor, const std::string& name) {
  const std::optional<FileFacts> facts = facts_of(descriptor);
  if (!facts) fail_by_errno(name);
  if (facts->kind == FileKind::folder) fail_to_read(name, "Is a directory");
  if (facts->kind == FileKind::device) fail_to_read(name, "is a device, not a file");
  return *facts;
}

void check_size(std::size_t size, const std::string& name, std::size_t most) {
  if (size > most)
    throw TooLargeError(
        at({name}, "is larger than " + megabytes(most) + ", the most that is read"));
}

std::string read_raw(const std::filesystem::path& path, const std::string& name, std::size_t most) {
  const Descriptor file = open_file(path, Opening::to_read);
  if (!file) fail_by_errno(name);
  const FileFacts facts = expected_facts(file.get(), name);
  const auto expected = static_cast<std::size_t>(facts.size);
  check_size(expected, name, most);
  std::string bytes;
  bytes.reserve(expected + 1);
  for (std::size_t size = 0;;) {
    const std::size_t room = std::max<std::size_t>(bytes.capacity() - size, 1 << 16);
    bytes.resize(size + room);
    const auto got =
        read_some(file.get(), std::as_writable_bytes(std::span(bytes)).subspan(size, room));
    if (got < 0) fail_by_errno(name);
    bytes.resize(size += static_cast<std::size_t>(got));
    if (got == 0 && size == 0 && facts.kind == FileKind::stream)
      fail_to_read(name, "is a pipe that nobody writes to");
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
  const std::string name = path_text(path);
  std::string bytes = read_raw(path, name, most);
  if (const Compression* compression = compression_of(bytes))
    return expand(*compression, bytes, name, most);
  return bytes;
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
