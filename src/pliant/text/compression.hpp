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
  std::string_view name;                  ///< "gzip"
  std::string_view suffix;                ///< ".gz", that of files
  std::string_view magic;                 ///< the bytes that each of its files begins with
  std::string_view library;               ///< what reads it: "zlib"; "": nothing does
  std::unique_ptr<Decoder> (*decoder)();  ///< gives null where the build has no such library
};

/// The compression that `bytes` begin with; null if they are not compressed.
const Compression* compression_of(std::string_view bytes);

/// What `bytes`, which begin with the magic of `compression`, hold: all members of the file one
/// after the other. `name` is for messages.
///
/// What is large is counted before it is kept, so that a file beyond `most` bytes is refused in
/// less than 100 MiB. Throws TooLargeError then; InputError where the file is damaged or cut, or
/// nothing here reads this compression.
std::string expand(const Compression& compression, std::string_view bytes, std::string_view name,
                   std::size_t most);

/// "1abc.pdb" of "1abc.pdb.gz": without the suffix of a compression that is read, in any case.
std::filesystem::path without_compression_suffix(const std::filesystem::path& path);

}  // namespace pliant
