// SPDX-License-Identifier: MIT
// Matches the residues of two structures: chain by chain, by number where that fits, else by
// sequence.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/path/trace.hpp"

namespace pliant {

/// Matched residues of two traces.
struct ResidueMatch {
  std::vector<std::uint32_t> ours;    ///< (K) rising
  std::vector<std::uint32_t> theirs;  ///< (K)
  std::vector<std::string> notes;     ///< method, differences, and what was left out
};

/// Matches chains, those with most residues in common first, then residues within them: by chain
/// and number if 9 of 10 residues found so are the same, else by sequence (align). Chains with less
/// than 3 of 10 residues in common are different molecules. `source` names their structure in notes
/// and errors. Throws InputError if less than half of our residues, or less than 3, are matched.
ResidueMatch match_residues(const Trace& ours, const Trace& theirs, std::string_view source);

}  // namespace pliant
