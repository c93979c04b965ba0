// SPDX-License-Identifier: MIT
// Torsion preferences: turns about bonds that are usual.
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <numbers>

#include "arrays.hpp"
#include "pliant/framework/torsion_preferences.hpp"

namespace pliant::python {
namespace {

using Index = std::uint32_t;
using StaggeredRow = std::tuple<Index, Index, Index, Index, double>;
using BackboneRow = std::tuple<Index, Index, Index, Index, Index, double>;

constexpr double degree = std::numbers::pi / 180.0;

void make_preferences(TorsionPreferences* self, const std::vector<StaggeredRow>& staggered,
                      const std::vector<BackboneRow>& backbone) {
  TorsionPreferences made;
  for (const auto& [a, b, c, d, free] : staggered)
    made.staggered.push_back({{a, b, c, d}, free * degree});
  for (const auto& [a, b, c, d, e, reach] : backbone)
    made.backbone.push_back({{a, b, c, d, e}, reach});
  new (self) TorsionPreferences(std::move(made));
}

std::vector<StaggeredRow> staggered_of(const TorsionPreferences& self) {
  std::vector<StaggeredRow> rows;
  for (const auto& [at, free] : self.staggered)
    rows.emplace_back(at[0], at[1], at[2], at[3], free / degree);
  return rows;
}

std::vector<BackboneRow> backbone_of(const TorsionPreferences& self) {
  std::vector<BackboneRow> rows;
  for (const auto& [at, reach] : self.backbone)
    rows.emplace_back(at[0], at[1], at[2], at[3], at[4], reach);
  return rows;
}

constexpr const char* preferences_doc = R"(Torsions that pull back to where they are usual.

``sample`` uses them. They pull, but never decide whether a frame is whole.

Parameters
----------
staggered : sequence of (a, b, c, d, free)
    Torsions of joints a-b-c-d that are usual within ``free`` degrees of 60, 180 and 300.
backbone : sequence of (a, b, c, d, e, reach)
    phi (a-b-c-d) and psi (b-c-d-e) of a residue, usual in the regions of the Ramachandran plot (the
    99 % contours of Lovell et al., Proteins 50 (2003) 437, as ellipses) enlarged by ``reach``.
)";

}  // namespace

void bind_torsion_preferences(nb::module_& module) {
  nb::class_<TorsionPreferences>(module, "TorsionPreferences", preferences_doc)
      .def("__init__", &make_preferences, nb::kw_only(),
           "staggered"_a = std::vector<StaggeredRow>(), "backbone"_a = std::vector<BackboneRow>())
      .def_prop_ro("staggered", &staggered_of, "Rows as the constructor takes them, degrees.")
      .def_prop_ro("backbone", &backbone_of, "Rows as the constructor takes them.")
      .def("__repr__", [](const TorsionPreferences& self) {
        return "<pliant.TorsionPreferences: " + std::to_string(self.staggered.size()) +
               " staggered, " + std::to_string(self.backbone.size()) + " backbone>";
      });
}

}  // namespace pliant::python
