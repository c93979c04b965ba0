// SPDX-License-Identifier: MIT
// Where labels of residues are.
#include "fit/labels.hpp"

#include "arrays.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/error.hpp"
#include "pliant/fit/accessible_volume.hpp"
#include "pliant/fit/residue_sites.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"

namespace pliant::python {
namespace {

/// From an alpha carbon: of the four bonds of a tetrahedron two are known, of the others this is
/// the one of L amino acids. Of length 1.
Vec3 outward(Vec3 alpha, Vec3 n, Vec3 c) {
  constexpr double down = 0.5774, aside = 0.8165;
  const Vec3 to_n = (1.0 / distance(n, alpha)) * (n - alpha);
  const Vec3 to_c = (1.0 / distance(c, alpha)) * (c - alpha);
  const Vec3 middle = to_n + to_c, across = cross(to_n, to_c);
  return (-down / norm(middle)) * middle + (aside / norm(across)) * across;
}

/// From alpha carbons to their beta carbons, as N and C say; 0 without these.
std::vector<Vec3> outward_arms(const Structure& structure, std::span<const std::uint32_t> alphas) {
  const AtomTable& atoms = structure.atoms;
  std::vector<std::optional<Vec3>> n(atoms.residues.size()), c(atoms.residues.size());
  for (std::size_t atom = 0; atom < structure.size(); ++atom) {
    if (atoms.names[atom] == "N") n[atoms.residue_of[atom]] = structure.positions[atom];
    if (atoms.names[atom] == "C") c[atoms.residue_of[atom]] = structure.positions[atom];
  }
  std::vector<Vec3> out;
  for (const std::uint32_t alpha : alphas) {
    const auto &to_n = n[atoms.residue_of[alpha]], &to_c = c[atoms.residue_of[alpha]];
    out.push_back(to_n && to_c ? outward(structure.positions[alpha], *to_n, *to_c) : Vec3());
  }
  return out;
}

/// (M, 3) in the frames of nodes: one Angstrom from alpha carbons towards where beta carbons are.
/// 0 for nodes without N and C, and at the ends of chains.
PositionsView outward_places(const Structure& structure) {
  const ResidueNodes all = residue_nodes(structure);
  FitNodes nodes;
  std::vector<std::uint32_t> alphas;
  for (std::size_t k = 0; k < all.positions.size(); ++k) {
    if (!all.is_residue[k]) continue;
    nodes.positions.push_back(all.positions[k]);
    nodes.chain.push_back(all.chain[k]);
    alphas.push_back(all.atom[k]);
  }
  const std::vector<Vec3> arms = outward_arms(structure, alphas);
  std::vector<Vec3> out;
  for (std::uint32_t k = 0; k < arms.size(); ++k)
    out.push_back(residue_site(nodes, k, arms[k]).local);
  return new_positions(std::move(out));
}

/// (m, 3) of a label attached at a point.
PositionsView volume(const ArrayLike& positions, const ArrayLike& radii, const ArrayLike& attached,
                     double length, double width, double radius) {
  const std::vector<Vec3> atoms = positions_from(positions);
  const std::vector<double> at = reals_from(attached, "attached");
  if (at.size() != 3) throw InputError("attached: expected a point (3)");
  std::vector<Vec3> found = accessible_volume(atoms, reals_from(radii, "radii"),
                                              {at[0], at[1], at[2]}, {length, width, radius});
  return new_positions(std::move(found));
}

constexpr const char* accessible_volume_doc =
    R"(Where the centre of a dye on a flexible linker can be (S. Kalinin et al., Nat. Methods 9 (2012)
1218): points (M, 3) of a grid of 1 Angstrom.

`positions` (N, 3) and `radii` (N) of atoms, `attached` (3): where the linker begins; its `length`
and `width`, and the `radius` of the dye; all Angstrom. Empty where atoms leave no room.
)";

}  // namespace

void bind_labels(nb::module_& module) {
  module.def(
      "outward_places", &outward_places, "structure"_a,
      nb::sig("def outward_places(structure: Structure) -> "
              "numpy.typing.NDArray[numpy.float64]"),
      "(M, 3) a place 1 Angstrom from each alpha carbon towards the beta carbon: (a, b, c) of"
      "\na u + b v + c u x v, where u and v lead to the next and to the previous alpha "
      "carbon.\n0 at ends of chains and for nucleotides.");
  module.def("accessible_volume", &volume, "positions"_a, "radii"_a, "attached"_a,
             "length"_a = Dye().length, "width"_a = Dye().width, "radius"_a = Dye().radius,
             nb::sig("def accessible_volume(positions: numpy.typing.ArrayLike, "
                     "radii: numpy.typing.ArrayLike, attached: numpy.typing.ArrayLike, "
                     "length: float = 20.0, width: float = 4.5, radius: float = 3.5) -> "
                     "numpy.typing.NDArray[numpy.float64]"),
             accessible_volume_doc);
}

}  // namespace pliant::python
