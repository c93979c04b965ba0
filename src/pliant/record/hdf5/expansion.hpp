// SPDX-License-Identifier: MIT
// How much memory a dataset may take when it is read: in proportion to what its file holds.
#pragma once

#include <cstdint>
#include <string>

namespace pliant {

/// Bytes of a dataset that are asked for, and what the file holds of it.
struct Expansion {
  std::uint64_t values = 0;     ///< bytes of all values that are wanted
  std::uint64_t at_once = 0;    ///< bytes of those that are in memory at the same time
  std::uint64_t chunk = 0;      ///< bytes of one chunk once it is unpacked; 0: not chunked
  std::uint64_t stored = 0;     ///< bytes of all its values in the file, packed or not
  std::uint64_t chunks = 1;     ///< how many chunks these are
  std::uint64_t file_size = 0;  ///< bytes: chunks may state the same place in the file twice
  /// So many bytes of values may be asked for though they were never written: HDF5 fills them in.
  std::uint64_t unwritten = 0;
};

/// Product that stops at the largest number.
std::uint64_t times(std::uint64_t a, std::uint64_t b);

/// Up to here a chunk may be made whatever the file holds.
inline constexpr std::uint64_t harmless_chunk = std::uint64_t{1} << 24;
/// From here on chunks and values must not be much larger than what the file holds of them. A chunk
/// of one frame reaches it at 2.8 million atoms.
inline constexpr std::uint64_t large_expansion = std::uint64_t{1} << 26;

/// Why these bytes are not asked for; empty if they may be. HDF5 unpacks a chunk as a whole, and
/// deflate makes a thousand bytes of one: what is large must have a hundredth of its size in the
/// file. Coordinates of molecules pack by ten at most.
std::string refusal_of(const Expansion& expansion);

}  // namespace pliant
