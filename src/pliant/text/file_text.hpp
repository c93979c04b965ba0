// SPDX-License-Identifier: MIT
// From a path to text that can be read: bytes in bounded memory, gzip undone, encodings told.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace pliant {

/// The text of a file and how to speak of it.
struct SourceText {
  std::string_view name;  ///< file name for messages
  std::string_view text;  ///< all of it, without a UTF-8 byte order mark
};

/// Files (and what gzip inflates to) beyond this are refused: 4 GiB, 1 GiB where addresses have 32
/// bits.
inline constexpr std::size_t largest_text = std::size_t{1} << (sizeof(std::size_t) > 4 ? 32 : 30);

/// All bytes of a regular file, pipe or socket, gzip undone (by its magic bytes).
/// Throws FileError with the system's reason, for directories and devices too; InputError for more
/// than largest_text bytes, other compressions and damaged gzip.
std::string read_bytes(const std::filesystem::path& path);

/// The same text without a UTF-8 byte order mark.
std::string_view without_byte_order_mark(std::string_view text);

/// Throws InputError for an empty text, UTF-16, UTF-32 and binary bytes (naming the line of the
/// first); no byte of them gets into the message.
void check_text(const SourceText& source);

}  // namespace pliant
