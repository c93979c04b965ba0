// SPDX-License-Identifier: MIT
// Technique `auto`: chooses a technique by what the bars of the framework form.
#pragma once

#include <memory>
#include <string>

#include "pliant/resolve/techniques.hpp"

namespace pliant {

/// What `auto` takes, and why.
struct Choice {
  Technique technique;
  std::string why;  ///< "the bars close no cycle: one outward pass makes them whole"
};

/// Chooses by structure alone, so that every walker and every run of a framework gets the same.
/// `asked` says whether masses count. Linear in joints and bars, but for hubs of many bars.
Choice choose_technique(const Framework& framework, const Technique& asked = {});

/// Whether most bars are in triangles, as bars across angles make them, and some block of bars is
/// larger than a tetrahedron: rigid units, which share joints. Not of frameworks in a plane.
bool forms_rigid_units(const Framework& framework);

/// The technique that resolves: what `auto` chooses, any other itself.
Technique technique_used(const Framework& framework, const Technique& technique);

std::unique_ptr<Method> make_automatic(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options);

}  // namespace pliant
