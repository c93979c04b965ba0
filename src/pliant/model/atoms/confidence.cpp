// SPDX-License-Identifier: MIT
#include "pliant/model/atoms/confidence.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"

namespace pliant {
namespace {

// A structure of fewer residues whose B factors are equal in each says nothing.
constexpr std::size_t fewest_residues = 10;

// A scale from 0 to 1 is another one.
bool are_in_percent(const std::vector<float>& b) {
  const auto [least, most] = std::ranges::minmax_element(b);
  return *least >= 0.0F && *most > 1.0F && *most <= 100.0F;
}

/// pLDDT has one value for each residue, from above 0 to 100, and no water.
bool look_like_confidences(const Structure& structure) {
  const AtomTable& atoms = structure.atoms;
  const ResidueAtoms residues(atoms);
  const auto& b = structure.b_factors;
  if (std::ranges::any_of(atoms.residues, is_water)) return false;
  std::size_t of_several = 0;
  bool varies = false;
  for (std::size_t r = 0; r < atoms.residues.size(); ++r) {
    const float first = b[residues.begin(r)];
    varies |= first != b[0];
    for (std::uint32_t i = residues.begin(r); i < residues.end(r); ++i)
      if (b[i] != first || b[i] <= 0.0F || b[i] > 100.0F) return false;
    of_several += residues.end(r) - residues.begin(r) > 3 ? 1 : 0;
  }
  return varies && of_several >= fewest_residues;
}

}  // namespace

bool has_confidences(const Structure& structure) {
  if (structure.b_factors.empty()) return false;
  if (structure.b_factor_source == BFactorSource::experiment) return false;
  if (structure.b_factor_source == BFactorSource::confidence)
    return are_in_percent(structure.b_factors);
  return look_like_confidences(structure);
}

std::string why_no_b_factors(const Structure& structure) {
  const std::string says = " (" + structure.b_factor_record + ")";
  switch (structure.b_factor_source) {
    case BFactorSource::experiment:
      return {};
    case BFactorSource::model:
      return "the file says that it is a theoretical model" + says + ", which has none";
    case BFactorSource::confidence:
      return "the file says that they are confidences such as pLDDT" + says;
    case BFactorSource::unknown:
      break;
  }
  if (!look_like_confidences(structure)) return {};
  return "the B factors look like confidences (pLDDT): one value a residue, none above 100, and "
         "the "
         "file names no experiment (EXPDTA, _exptl.method)";
}

}  // namespace pliant
