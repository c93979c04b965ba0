// SPDX-License-Identifier: MIT
// Which residue of theirs is which of ours: chain by chain, by number where that fits, else by
// sequence.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/path/trace.hpp"

namespace pliant {

/// Residues of two traces that stand for each other.
struct ResidueMatch {
  std::vector<std::uint32_t> ours;    ///< (K) rising
  std::vector<std::uint32_t> theirs;  ///< (K)
  std::vector<std::string> notes;     ///< how, what differs, what is left out
};

/// Matches chains, those that share most first, then residues within them: by chain and number
/// where 9 of 10 residues found so are the same, else by sequence (align). Chains that have less
/// than 3 of 10 in common are other molecules. `source` is theirs, for notes and errors.
/// Throws InputError where less than half of our residues are found, or less than 3.
ResidueMatch match_residues(const Trace& ours, const Trace& theirs, std::string_view source);

}  // namespace pliant
