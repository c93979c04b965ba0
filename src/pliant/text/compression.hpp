// SPDX-License-Identifier: MIT
// Compressed files: the table of compressions that are known, and expanding in bounded memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "pliant/text/decoder.hpp"

namespace pliant {

/// A compression: one row of the table.
struct Compression {
  std::string_view name;     ///< "gzip"
  std::string_view suffix;   ///< ".gz", that of files
  std::string_view magic;    ///< the bytes that each of its files begins with
  std::string_view library;  ///< what reads it: "zlib"; "": nothing does
  /// makes a decoder; null where the build lacks the library
  std::unique_ptr<Decoder> (*decoder)();
};

/// The compression that `bytes` begin with; null if they are not compressed.
const Compression* compression_of(std::string_view bytes);

/// Returns what `bytes`, which begin with the magic of `compression`, hold: all members of the file
/// one after the other. `name` is for messages.
///
/// Large contents are counted before they are kept, so that a file beyond `most` bytes is refused
/// in less than 100 MiB. Throws TooLargeError then; InputError where the file is damaged or cut, or
/// where this build cannot read the compression.
std::string expand(const Compression& compression, std::string_view bytes, std::string_view name,
                   std::size_t most);

/// "1abc.pdb" for "1abc.pdb.gz": removes the suffix of a known compression, in any case.
std::filesystem::path without_compression_suffix(const std::filesystem::path& path);

}  // namespace pliant
