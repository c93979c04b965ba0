// SPDX-License-Identifier: MIT
// From a path to text: bytes in bounded memory, compression undone, encodings recognized.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "pliant/base/error.hpp"

namespace pliant {

/// The text of a file and how to speak of it.
struct SourceText {
  std::string_view name;  ///< file name for messages
  std::string_view text;  ///< all of it, without a UTF-8 byte order mark
};

/// The input is larger than the caller allows. Its contents have not been checked.
class TooLargeError : public InputError {
 public:
  using InputError::InputError;
};

/// A file is refused if it, or what it expands to, has more than usual_text bytes: 2 GB, or 1 GB
/// where addresses have 32 bits. Callers may choose another limit, up to largest_text.
inline constexpr std::size_t usual_text =
    std::size_t{sizeof(std::size_t) > 4 ? 2u : 1u} * 1000000000;
inline constexpr std::size_t largest_text = std::size_t{1} << (sizeof(std::size_t) > 4 ? 32 : 30);

/// Reads all bytes of a regular file, pipe or socket; gzip, bzip2 and xz are recognized by their
/// magic bytes and undone. Throws FileError with the system's reason, for directories and devices
/// too; TooLargeError for more than `most` bytes, before they are in memory; InputError for other
/// compressions and damaged files.
std::string read_bytes(const std::filesystem::path& path, std::size_t most = usual_text);

/// "2000 MB", or "123 bytes" where it is no whole number of megabytes (10^6).
std::string megabytes(std::size_t bytes);

/// The same text without a UTF-8 byte order mark.
std::string_view without_byte_order_mark(std::string_view text);

/// Throws InputError for an empty text, UTF-16, UTF-32 and binary bytes, naming the line of the
/// first. The message contains none of those bytes.
void check_text(const SourceText& source);

}  // namespace pliant
