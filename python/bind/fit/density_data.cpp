// SPDX-License-Identifier: MIT
#include "fit/density_data.hpp"

#include "arrays.hpp"
#include "fit/map_agreement.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"

namespace pliant::python {
namespace {

constexpr double margin = 20.0;  // Angstrom: of a map around the frames that are fitted

/// The atoms of the residues of polymers, with nodes as nodes_to_fit() gives them.
struct ResidueMass {
  FitNodes nodes;
  std::vector<Vec3> atoms;
  std::vector<double> weights;
  std::vector<std::uint32_t> node_of;

  explicit ResidueMass(const Structure& structure);
  ResidueSites sites(std::size_t parts) const { return {nodes, atoms, weights, node_of, parts}; }
};

ResidueMass::ResidueMass(const Structure& structure) {
  const ResidueNodes all = residue_nodes(structure);
  std::vector<std::uint32_t> number(all.positions.size(), no_residue_node);
  for (std::size_t k = 0; k < all.positions.size(); ++k) {
    if (!all.is_residue[k]) continue;
    number[k] = static_cast<std::uint32_t>(nodes.positions.size());
    nodes.positions.push_back(all.positions[k]);
    nodes.chain.push_back(all.chain[k]);
  }
  for (std::size_t atom = 0; atom < structure.size(); ++atom) {
    const std::uint32_t of = all.of_atom[atom];
    if (of == no_residue_node || number[of] == no_residue_node) continue;
    atoms.push_back(structure.positions[atom]);
    weights.push_back(structure.atoms.elements[atom]);
    node_of.push_back(number[of]);
  }
}

std::vector<Vec3> all_of(const GivenFrames& frames) {
  std::vector<Vec3> out;
  for (std::size_t k = 0; k < frames.shape(0); ++k) {
    const std::span<const Vec3> frame = frame_of(frames, k);
    out.insert(out.end(), frame.begin(), frame.end());
  }
  return out;
}

DensityTarget target_of(const DensityMap& map, double resolution, const Structure& structure,
                        const GivenFrames& frames) {
  const ResidueMass mass(structure);
  return {cropped(map, all_of(frames), margin), median(map), resolution, mass.sites(1),
          mass.sites(2)};
}

/// (F) at the coarse or at the fine level.
Array1<double> correlations(const DensityTarget& density, const GivenFrames& frames, bool fine) {
  check_sites(density, frames.shape(1));
  std::vector<double> out(frames.shape(0));
  {
    const nb::gil_scoped_release no_gil;
    for_each_in_threads(all_processors(), out.size(), [&](std::size_t k) {
      DensityTerm term(density);
      term.begin(fine ? std::size(fit_weights) - 1 : 0, frame_of(frames, k));
      out[k] = term.correlation(frame_of(frames, k));
    });
  }
  return array_of(std::move(out));
}

constexpr const char* density_data_doc =
    R"(A map of some resolution (Angstrom), and the mass of a structure that is to explain it.

Of the map the part around the nodes of `frames` (F, M, 3) is kept; its median counts as nothing.
)";

}  // namespace

void check_sites(const DensityTarget& density, std::size_t nodes) {
  if (density.node_count() != nodes)
    throw InputError("density: expected frames of " + std::to_string(density.node_count()) +
                     " nodes, found " + std::to_string(nodes));
}

void bind_density_data(nb::module_& module) {
  nb::class_<DensityTarget>(module, "DensityData", density_data_doc)
      .def(
          "__init__",
          [](DensityTarget* self, const DensityMap& map, double resolution,
             const Structure& structure, const GivenFrames& frames) {
            new (self) DensityTarget(target_of(map, resolution, structure, frames));
          },
          "map"_a, "resolution"_a, "structure"_a, "frames"_a,
          nb::sig("def __init__(self, map: DensityMap, resolution: float, structure: Structure, "
                  "frames: numpy.typing.NDArray[numpy.float64]) -> None"))
      .def("correlations", &correlations, "frames"_a, "fine"_a,
           nb::sig("def correlations(self, frames: numpy.typing.NDArray[numpy.float64], "
                   "fine: bool) -> numpy.typing.NDArray[numpy.float64]"),
           "(F,) the correlation, about the background, of the map and of frames of nodes, at the "
           "resolution\n(fine) or at twice that.");
}

}  // namespace pliant::python
