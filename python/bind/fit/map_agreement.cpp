// SPDX-License-Identifier: MIT
#include "fit/map_agreement.hpp"

#include "arrays.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/error.hpp"
#include "pliant/fit/map/agreement.hpp"
#include "pliant/fit/map/placing.hpp"
#include "pliant/fit/map/unexplained.hpp"

namespace pliant::python {
namespace {

double correlation_of(const DensityMap& map, const nb::handle& structure, double resolution,
                      std::optional<double> radius) {
  const WeighedAtoms atoms = weighed_atoms(structure);
  const nb::gil_scoped_release no_gil;
  return MapAgreement(map, atoms.positions, atoms.weights, resolution,
                      radius.value_or(usual_mask_radius(resolution)))
      .overall();
}

Array1<double> local_correlation_of(const DensityMap& map, const nb::handle& structure,
                                    double resolution, std::optional<double> radius) {
  const nb::object given = structure_from(structure);
  const auto& from = nb::cast<const Structure&>(given);
  const WeighedAtoms atoms = weighed_atoms(from);
  return array_of(MapAgreement(map, atoms.positions, atoms.weights, resolution,
                               radius.value_or(usual_mask_radius(resolution)))
                      .by_group(atoms.residue_of, from.atoms.residues.size()));
}

nb::tuple unexplained_by(const DensityMap& map, const nb::handle& structure,
                         std::optional<double> threshold, double radius) {
  const WeighedAtoms atoms = weighed_atoms(structure);
  const UnexplainedDensity found =
      unexplained_density(map, atoms.positions, threshold.value_or(usual_threshold(map)), radius);
  std::vector<Vec3> centers;
  std::vector<double> shares;
  for (const DensityBlob& blob : found.blobs) {
    centers.push_back(blob.center);
    shares.push_back(blob.share);
  }
  return nb::make_tuple(found.share, new_positions(std::move(centers)),
                        array_of(std::move(shares)));
}

/// (n, N, 3) positions, and (n) densities.
nb::tuple placings_in(const DensityMap& map, const nb::handle& structure, double resolution,
                      std::size_t most) {
  const nb::object given = structure_from(structure);
  const auto& from = nb::cast<const Structure&>(given);
  const WeighedAtoms atoms = weighed_atoms(from);
  std::vector<Vec3> all;
  std::vector<double> densities;
  {
    const nb::gil_scoped_release no_gil;
    for (const Placing& found :
         place_in_map(map, atoms.positions, atoms.weights, resolution, most)) {
      for (const Vec3 position : from.positions) all.push_back(found.motion(position));
      densities.push_back(found.density);
    }
  }
  const std::size_t count = densities.size();
  return nb::make_tuple(new_frames(std::move(all), count, from.size()),
                        array_of(std::move(densities)));
}

nb::tuple placed_in(const DensityMap& map, const nb::handle& structure, double resolution) {
  const nb::tuple found = placings_in(map, structure, resolution, 1);
  return nb::make_tuple(found[0][0], nb::cast<double>(found[1][0]));
}

constexpr const char* correlation_doc =
    R"(The correlation, about the means, with the map that a molecule would have.

At points of the map near to an atom.

Parameters
----------
structure : Structure
resolution : float
    That of the map, Angstrom.
radius : float, optional
    How near, Angstrom. None: half of the resolution, at least 3.

Returns
-------
float
    From -1 to 1; 0 where one of both is the same everywhere.

Raises
------
OptionError
    A number is out of its range.
InputError
    The molecule is outside of the map.
)";

constexpr const char* local_correlation_doc =
    R"(The correlation, as ``correlation`` has it, at points near to each residue.

Parameters
----------
structure : Structure
resolution : float
    That of the map, Angstrom.
radius : float, optional
    How near, Angstrom. None: half of the resolution, at least 3.

Returns
-------
(R,) float64
    One for each residue of the structure; 0 for those outside of the map.

Raises
------
OptionError
    A number is out of its range.
)";

constexpr const char* unexplained_doc =
    R"(Density that no atom is near to.

Density counts from the threshold up.

Parameters
----------
structure : Structure
threshold : float, optional
    None: two deviations above the mean of the map.
radius : float
    Points further than this from every atom are not explained, Angstrom.

Returns
-------
share : float
    Of all density above the threshold, from 0 to 1.
centers : (B, 3) float64
    Of its largest pieces, five at most, largest first; Angstrom.
shares : (B,) float64
    Of each of these.

Raises
------
OptionError
    No value is above the threshold, or a number is out of its range.
)";

constexpr const char* place_doc =
    R"(Puts a molecule into the map as a rigid body, wherever it was before.

Rotations are tried about the center of density and other dense places in the map blurred to twice
its resolution; the best go uphill there, then in the map itself.

Parameters
----------
structure : Structure
resolution : float
    That of the map, Angstrom.

Returns
-------
positions : (N, 3) float64
    Angstrom.
density : float
    The mean at the atoms by atomic number, where the greatest of the map is 1.

Raises
------
OptionError
    The resolution is out of its range.
InputError
    The map is nowhere above 0, or the molecule has fewer than three atoms of known elements.
)";

}  // namespace

WeighedAtoms weighed_atoms(const Structure& structure) {
  WeighedAtoms out;
  for (std::size_t k = 0; k < structure.size(); ++k) {
    const std::uint8_t element = structure.atoms.elements[k];
    if (element == 0) continue;
    out.positions.push_back(structure.positions[k]);
    out.weights.push_back(element);
    out.residue_of.push_back(structure.atoms.residue_of[k]);
  }
  if (out.positions.empty()) throw InputError("structure: no atom has a known element");
  return out;
}

WeighedAtoms weighed_atoms(const nb::handle& structure) {
  const nb::object given = structure_from(structure);
  return weighed_atoms(nb::cast<const Structure&>(given));
}

void bind_map_agreement(nb::class_<DensityMap>& bound) {
  bound
      .def("correlation", &correlation_of, "structure"_a, "resolution"_a, "radius"_a = nb::none(),
           nb::sig("def correlation(self, structure: Structure | Molecule, resolution: float, "
                   "radius: float | None = None) -> float"),
           correlation_doc)
      .def("local_correlation", &local_correlation_of, "structure"_a, "resolution"_a,
           "radius"_a = nb::none(),
           nb::sig("def local_correlation(self, structure: Structure | Molecule, "
                   "resolution: float, radius: float | None = None) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           local_correlation_doc)
      .def("unexplained", &unexplained_by, "structure"_a, "threshold"_a = nb::none(),
           "radius"_a = 3.0,
           nb::sig("def unexplained(self, structure: Structure | Molecule, "
                   "threshold: float | None = None, radius: float = 3.0) -> "
                   "tuple[float, numpy.typing.NDArray[numpy.float64], "
                   "numpy.typing.NDArray[numpy.float64]]"),
           unexplained_doc)
      .def("place", &placed_in, "structure"_a, "resolution"_a,
           nb::sig("def place(self, structure: Structure | Molecule, resolution: float) -> "
                   "tuple[numpy.typing.NDArray[numpy.float64], float]"),
           place_doc)
      .def("placings", &placings_in, "structure"_a, "resolution"_a, "most"_a,
           nb::sig("def placings(self, structure: Structure | Molecule, resolution: float, "
                   "most: int) -> tuple[numpy.typing.NDArray[numpy.float64], "
                   "numpy.typing.NDArray[numpy.float64]]"),
           "The densest places of a molecule in the map, at most so many, as ``place`` finds "
           "them:\npositions (n, N, 3) and the mean densities (n,).");
}

}  // namespace pliant::python
