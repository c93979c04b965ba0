// SPDX-License-Identifier: MIT
// Bounds the memory for reading a dataset, in proportion to what the file stores.
#pragma once

#include <cstdint>
#include <string>

namespace pliant {

/// Size of a dataset in memory, and in the file.
struct Expansion {
  std::uint64_t values = 0;     ///< bytes of all values to be read
  std::uint64_t at_once = 0;    ///< bytes of those that are in memory at the same time
  std::uint64_t chunk = 0;      ///< bytes of one chunk once it is unpacked; 0: not chunked
  std::uint64_t stored = 0;     ///< bytes of all its values as stored, compressed or not
  std::uint64_t chunks = 1;     ///< number of stored chunks
  std::uint64_t file_size = 0;  ///< bytes; several chunks may refer to the same place in the file
  /// Bytes of values that may be missing from the file: HDF5 fills them in.
  std::uint64_t unwritten = 0;
};

/// Product, limited to the largest number.
std::uint64_t times(std::uint64_t a, std::uint64_t b);

/// A chunk up to this size is accepted whatever the file stores.
inline constexpr std::uint64_t harmless_chunk = std::uint64_t{1} << 24;
/// From this size on, chunks and values must not be much larger than what is stored. A chunk of one
/// frame has this size at 2.8 million atoms.
inline constexpr std::uint64_t large_expansion = std::uint64_t{1} << 26;

/// Says why the dataset is refused; empty if it is not. HDF5 decompresses a chunk as a whole, and
/// deflate can expand a byte to a thousand, so large datasets must occupy a hundredth of their size
/// in the file. Coordinates of molecules compress by at most ten.
std::string refusal_of(const Expansion& expansion);

}  // namespace pliant
