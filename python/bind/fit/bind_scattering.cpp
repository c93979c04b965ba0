// SPDX-License-Identifier: MIT
// What molecules scatter at small angles.
#include <algorithm>

#include "arrays.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/fit/saxs/partial_profiles.hpp"
#include "pliant/measure/grid.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/prepare/carbon_hydrogens.hpp"

namespace pliant::python {
namespace {

std::vector<ScatteringGroup> groups_of(const ArrayLike& elements, const ArrayLike& hydrogens) {
  const std::vector<std::int64_t> element = integers_from(elements, "elements");
  const std::vector<std::int64_t> count = integers_from(hydrogens, "hydrogens");
  if (element.size() != count.size()) throw InputError("hydrogens: expected one for each element");
  std::vector<ScatteringGroup> groups;
  for (std::size_t k = 0; k < element.size(); ++k) {
    if (element[k] < 1 || element[k] > 118 || count[k] < 0 || count[k] > 8)
      throw InputError("elements, hydrogens: row " + std::to_string(k) +
                       ": expected an atomic number and at most 8 hydrogens");
    groups.push_back({std::uint8_t(element[k]), std::uint8_t(count[k])});
  }
  return groups;
}

/// Hydrogens bonded to each atom, and those on carbon that it lacks.
nb::tuple scattering_groups(const Structure& structure) {
  const AtomGraph graph(structure);
  std::vector<std::int64_t> hydrogens(structure.size()), atoms, elements, counts;
  for (const PlacedHydrogen& placed : place_carbon_hydrogens(structure)) ++hydrogens[placed.parent];
  for (std::uint32_t atom = 0; atom < structure.size(); ++atom) {
    const std::uint8_t element = structure.atoms.elements[atom];
    if (element <= 1) continue;
    atoms.push_back(atom);
    elements.push_back(element);
    counts.push_back(hydrogens[atom] + std::int64_t(graph.hydrogens_at(atom)));
  }
  return nb::make_tuple(array_of(std::move(atoms)), array_of(std::move(elements)),
                        array_of(std::move(counts)));
}

nb::tuple form_factors(const ArrayLike& elements, const ArrayLike& hydrogens, const ArrayLike& q) {
  const std::vector<ScatteringGroup> groups = groups_of(elements, hydrogens);
  const std::vector<double> at = reals_from(q, "q");
  std::vector<double> vacuum, displaced, volumes;
  for (const ScatteringGroup group : groups) {
    volumes.push_back(displaced_volume(group));
    for (const double one : at) {
      vacuum.push_back(form_factor(group, one));
      displaced.push_back(displaced_form_factor(volumes.back(), one));
    }
  }
  return nb::make_tuple(array_of(std::move(vacuum)), array_of(std::move(displaced)),
                        array_of(std::move(volumes)));
}

/// The diagonal of a box around each frame, the longest of them.
double longest_in(const GivenFrames& frames) {
  double longest = 0.0;
  for (std::size_t k = 0; k < frames.shape(0); ++k) {
    const std::span<const Vec3> frame = frame_of(frames, k);
    for (const Vec3 at : frame)
      if (!is_finite(at)) throw InputError("frames: frame " + std::to_string(k) + " is not finite");
    if (frame.empty()) continue;
    const Extent extent = extent_of(frame);
    longest = std::max(longest, norm(extent.high - extent.low));
  }
  return longest;
}

using Profiles = nb::ndarray<nb::numpy, double, nb::shape<-1, -1, -1>, nb::c_contig>;

Profiles partial_profiles(const ArrayLike& elements, const ArrayLike& hydrogens,
                          const GivenFrames& frames, const ArrayLike& q) {
  const std::vector<ScatteringGroup> groups = groups_of(elements, hydrogens);
  const std::vector<double> at = reals_from(q, "q");
  const std::size_t count = frames.shape(0), size = partial_count * at.size();
  if (frames.shape(1) != groups.size())
    throw InputError("frames: expected " + std::to_string(groups.size()) +
                     " positions each, as there are elements, found " +
                     std::to_string(frames.shape(1)));
  auto* found = new std::vector<double>(count * size);
  const nb::capsule owner = owner_of(found);
  {
    const nb::gil_scoped_release no_gil;
    const PartialProfiles profiles(groups, at, longest_in(frames));
    for_each_in_threads(all_processors(), count, [&](std::size_t k) {
      std::ranges::copy(profiles.of(frame_of(frames, k)),
                        found->begin() + std::ptrdiff_t(k * size));
    });
  }
  return Profiles(found->data(), {count, partial_count, at.size()}, owner);
}

}  // namespace

void bind_scattering(nb::module_& module) {
  module.def("scattering_groups", &scattering_groups, "structure"_a,
             nb::sig("def scattering_groups(structure: Structure) -> "
                     "tuple[numpy.typing.NDArray[numpy.int64], numpy.typing.NDArray[numpy.int64], "
                     "numpy.typing.NDArray[numpy.int64]]"),
             "The heavy atoms (G), their elements, and how many hydrogens each has: those that are "
             "there,\nand on carbon of amino acids and nucleotides those that are not.");
  module.def("form_factors", &form_factors, "elements"_a, "hydrogens"_a, "q"_a,
             nb::sig("def form_factors(elements: numpy.typing.ArrayLike, "
                     "hydrogens: numpy.typing.ArrayLike, q: numpy.typing.ArrayLike) -> "
                     "tuple[numpy.typing.NDArray[numpy.float64], "
                     "numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]"),
             "Of heavy atoms (G) with hydrogens: form factors in a vacuum (G * K) at each q "
             "(1/Angstrom),\nthose of the solvent that they displace (G * K), and its volumes "
             "(G, Angstrom^3).");
  module.def("partial_profiles", &partial_profiles, "elements"_a, "hydrogens"_a, "frames"_a, "q"_a,
             nb::sig("def partial_profiles(elements: numpy.typing.ArrayLike, "
                     "hydrogens: numpy.typing.ArrayLike, "
                     "frames: numpy.typing.NDArray[numpy.float64], q: numpy.typing.ArrayLike) -> "
                     "numpy.typing.NDArray[numpy.float64]"),
             "What heavy atoms with hydrogens scatter in each frame (F, G, 3), Angstrom, at each q "
             "(K,\n1/Angstrom): (F, 6, K) the products vv, vd, dd, vw, dw and ww of the amplitudes "
             "of the molecule\nin a vacuum, of the solvent that it displaces and of water at its "
             "surface, electrons^2.");
}

}  // namespace pliant::python
