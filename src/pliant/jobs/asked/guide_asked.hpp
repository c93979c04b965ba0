// SPDX-License-Identifier: MIT
// Where a run is asked to go: modes, pulls and distances of pairs, by selections of atoms.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/option_fields.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/perturb/guide.hpp"

namespace pliant {

struct GuideAsked {
  std::int64_t rock = 0;   ///< mode, from 1; 0: none
  double amplitude = 1.0;  ///< of rocking; Angstrom, r.m.s. of residues
  OptionGroups pulls;      ///< selection, "x,y,z"
  OptionGroups pairs;      ///< selection, selection, "d" or "d1..d2"

  bool empty() const { return rock == 0 && pulls.empty() && pairs.empty(); }
};

/// The table of these options; recorded below "guide".
std::span<const OptionField<GuideAsked>> guide_fields();

/// Makes the guide of a framework made from that structure. Throws OptionError naming the option,
/// and what is wrong with its value.
Guide guide_from(const GuideAsked& asked, const Structure& structure, const Framework& framework);

}  // namespace pliant
