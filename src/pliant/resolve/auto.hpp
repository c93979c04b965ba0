// SPDX-License-Identifier: MIT
// Technique `auto`: chooses a technique by the structure of the bars.
#pragma once

#include <memory>
#include <string>

#include "pliant/resolve/techniques.hpp"

namespace pliant {

/// The technique that `auto` chooses, and why.
struct Choice {
  Technique technique;
  std::string why;  ///< "the bars close no cycle: one outward pass makes them whole"
};

/// Chooses by structure alone, so that every walker and every run of a framework gets the same
/// technique. Of `asked` only the weighting by mass counts. Linear in joints and bars, except for
/// hubs of many bars.
Choice choose_technique(const Framework& framework, const Technique& asked = {});

/// Whether most bars are in triangles, as with bars across angles, and some block of bars is larger
/// than a tetrahedron: the bars then form rigid units, which share joints. False for frameworks in
/// a plane.
bool forms_rigid_units(const Framework& framework);

/// The technique that is used: the one that `auto` chooses, or `technique` itself.
Technique technique_used(const Framework& framework, const Technique& technique);

std::unique_ptr<Method> make_automatic(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options);

}  // namespace pliant
