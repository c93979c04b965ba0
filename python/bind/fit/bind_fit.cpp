// SPDX-License-Identifier: MIT
// Fits of nodes to distances.
#include "pliant/fit/fit_nodes.hpp"

#include "arrays.hpp"
#include "fit/density_data.hpp"
#include "fit/labels.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/fit/distance_term.hpp"
#include "pliant/fit/map/density_term.hpp"
#include "pliant/model/atoms/residue_nodes.hpp"

namespace pliant::python {
namespace {

/// Chains by equal numbers that follow each other, as residue_nodes() gives them.
std::vector<std::uint32_t> chains_of(const ArrayLike& chains) {
  std::vector<std::uint32_t> out;
  for (const std::int64_t chain : integers_from(chains, "chains"))
    out.push_back(static_cast<std::uint32_t>(chain));
  return out;
}

/// Data, and their 2 K sites: each at a node of a pair, or where `local` (K, 2, 3) says.
struct GivenDistances {
  std::vector<FitDistance> data;
  std::vector<ResidueSite> sites;
};

GivenDistances distances_of(const ArrayLike& pairs, const ArrayLike& low, const ArrayLike& high,
                            const GivenFrames& local, const ArrayLike& more, std::size_t nodes) {
  const std::vector<Bar> ends = pairs_from(pairs, "pairs", nodes);
  const std::vector<double> least = reals_from(low, "low"), most = reals_from(high, "high");
  const std::vector<std::int64_t> others = integers_from(more, "more");
  if (least.size() != ends.size() || most.size() != ends.size() || local.shape(0) != ends.size() ||
      local.shape(1) != 2 || others.size() != ends.size())
    throw InputError("low, high, local, more: expected one for each pair");
  GivenDistances out;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::span<const Vec3> at = frame_of(local, k);
    const auto first = static_cast<std::uint32_t>(2 * k);
    if (others[k] < 0 || std::uint64_t(others[k]) >= ends.size() - k)
      throw InputError("more: expected how many of the pairs after it are of the same datum");
    out.data.push_back({first, first + 1, least[k], most[k], std::uint32_t(others[k])});
    out.sites.push_back({ends[k].a, at[0] != Vec3(), 1.0, at[0]});
    out.sites.push_back({ends[k].b, at[1] != Vec3(), 1.0, at[1]});
  }
  return out;
}

nb::tuple fitted(const GivenFrames& starts, const ArrayLike& chains, const ArrayLike& pairs,
                 const ArrayLike& low, const ArrayLike& high, const GivenFrames& local,
                 const ArrayLike& more, const DensityTarget* density, std::size_t stages) {
  const std::size_t count = starts.shape(0), nodes = starts.shape(1);
  const std::vector<std::uint32_t> chain = chains_of(chains);
  if (chain.size() != nodes) throw InputError("chains: expected one for each node");
  if (density != nullptr) check_sites(*density, nodes);
  if (stages < 1 || stages > std::size(fit_weights)) throw OptionError("stages: from 1 to 4");
  const GivenDistances given = distances_of(pairs, low, high, local, more, nodes);
  const ResidueSites sites(nodes, given.sites);
  std::vector<Vec3> all(count * nodes);
  std::vector<double> strain(count), misfit(count);
  {
    const nb::gil_scoped_release no_gil;
    for_each_in_threads(all_processors(), count, [&](std::size_t k) {
      const std::span<const Vec3> start = frame_of(starts, k);
      DistanceTerm distances(given.data, sites);
      std::optional<DensityTerm> map;
      std::vector<FitTerm*> terms{&distances};
      if (density != nullptr) terms.push_back(&map.emplace(*density));
      const FittedNodes found = fit_nodes({{start.begin(), start.end()}, chain}, terms, stages);
      std::ranges::copy(found.positions, all.begin() + std::ptrdiff_t(k * nodes));
      strain[k] = found.strain;
      misfit[k] = found.misfit;
    });
  }
  return nb::make_tuple(new_frames(std::move(all), count, nodes), array_of(std::move(strain)),
                        array_of(std::move(misfit)));
}

/// Residues alone: (M) their atoms, (M) chains.
nb::tuple nodes_to_fit(const Structure& structure) {
  const ResidueNodes found = residue_nodes(structure);
  std::vector<std::int64_t> atoms, chains;
  for (std::size_t k = 0; k < found.positions.size(); ++k) {
    if (!found.is_residue[k]) continue;
    atoms.push_back(found.atom[k]);
    chains.push_back(found.chain[k]);
  }
  return nb::make_tuple(array_of(std::move(atoms)), array_of(std::move(chains)));
}

}  // namespace

void bind_fit(nb::module_& module) {
  bind_density_data(module);
  bind_labels(module);
  module.def("nodes_to_fit", &nodes_to_fit, "structure"_a,
             nb::sig("def nodes_to_fit(structure: Structure) -> "
                     "tuple[numpy.typing.NDArray[numpy.int64], numpy.typing.NDArray[numpy.int64]]"),
             "The atom of each residue of a polymer (CA, P), and the number of its chain.");
  module.def("fit_nodes", &fitted, "starts"_a, "chains"_a, "pairs"_a, "low"_a, "high"_a, "local"_a,
             "more"_a, "density"_a = nb::none(), "stages"_a = std::size(fit_weights),
             nb::sig("def fit_nodes(starts: numpy.typing.NDArray[numpy.float64], "
                     "chains: numpy.typing.ArrayLike, pairs: numpy.typing.ArrayLike, "
                     "low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, "
                     "local: numpy.typing.NDArray[numpy.float64], more: numpy.typing.ArrayLike, "
                     "density: DensityData | None = None, stages: int = 4) -> "
                     "tuple[numpy.typing.NDArray[numpy.float64], "
                     "numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]"),
             "Fits nodes from each start (F, M, 3) to the distances of pairs (K, 2) of them, or of "
             "places\n`local` (K, 2, 3) beside them, as outward_places() gives these, each "
             "from low (K)\nto high (K), Angstrom; of a pair and `more` (K) pairs after it "
             "(sum of r^-6)^(-1/6) is;\nand to a density; data count more in each of four "
             "stages. Returns the fitted nodes, and of each fit the "
             "strain and the misfit.");
}

}  // namespace pliant::python
