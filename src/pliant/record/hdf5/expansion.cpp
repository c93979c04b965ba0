// SPDX-License-Identifier: MIT
#include "pliant/record/hdf5/expansion.hpp"

#include <algorithm>
#include <limits>

namespace pliant {
namespace {

// No filter makes more of a byte: deflate's limit is 1032, and shuffle changes no size.
constexpr std::uint64_t most_expansion = 1100;
// The same for what is large.
constexpr std::uint64_t most_of_large = 100;

std::string too_large(const std::string& what, std::uint64_t wanted, std::uint64_t stored) {
  const std::uint64_t allowed = std::max(large_expansion, times(most_of_large, stored));
  if (wanted <= allowed) return "";
  return "has " + what + " that unpack to " + std::to_string(wanted) +
         " bytes, of which the file has " + std::to_string(stored) + ": at most " +
         std::to_string(allowed) + " are allowed";
}

}  // namespace

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  return b != 0 && a > most / b ? most : a * b;
}

std::string refusal_of(const Expansion& expansion) {
  const std::uint64_t stored = std::min(expansion.stored, expansion.file_size);
  const std::uint64_t most = times(stored, most_expansion);
  if (expansion.values > std::max(most, expansion.unwritten) ||
      expansion.chunk > std::max(most, harmless_chunk))
    return "has " + std::to_string(stored) +
           " bytes in the file: it was never written, or is damaged";
  const std::uint64_t of_one = stored / std::max<std::uint64_t>(expansion.chunks, 1);
  const std::string chunks = too_large("chunks", expansion.chunk, of_one);
  return chunks.empty() ? too_large("values", expansion.at_once, stored) : chunks;
}

}  // namespace pliant
