// SPDX-License-Identifier: MIT
// Fits of nodes to distances.
#include "pliant/fit/fit_nodes.hpp"

#include "arrays.hpp"
#include "fit/density_data.hpp"
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
                            const GivenFrames& local, std::size_t nodes) {
  const std::vector<Bar> ends = pairs_from(pairs, "pairs", nodes);
  const std::vector<double> least = reals_from(low, "low"), most = reals_from(high, "high");
  if (least.size() != ends.size() || most.size() != ends.size() || local.shape(0) != ends.size() ||
      local.shape(1) != 2)
    throw InputError("low, high, local: expected one for each pair");
  GivenDistances out;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const std::span<const Vec3> at = frame_of(local, k);
    const auto first = static_cast<std::uint32_t>(2 * k);
    out.data.push_back({first, first + 1, least[k], most[k]});
    out.sites.push_back({ends[k].a, at[0] != Vec3(), 1.0, at[0]});
    out.sites.push_back({ends[k].b, at[1] != Vec3(), 1.0, at[1]});
  }
  return out;
}

nb::tuple fitted(const GivenFrames& starts, const ArrayLike& chains, const ArrayLike& pairs,
                 const ArrayLike& low, const ArrayLike& high, const GivenFrames& local,
                 const DensityTarget* density, std::size_t stages) {
  const std::size_t count = starts.shape(0), nodes = starts.shape(1);
  const std::vector<std::uint32_t> chain = chains_of(chains);
  if (chain.size() != nodes) throw InputError("chains: expected one for each node");
  if (density != nullptr) check_sites(*density, nodes);
  if (stages < 1 || stages > std::size(fit_weights)) throw OptionError("stages: from 1 to 4");
  const GivenDistances given = distances_of(pairs, low, high, local, nodes);
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

}  // namespace

void bind_fit(nb::module_& module) {
  bind_density_data(module);
  module.def("nodes_to_fit", &nodes_to_fit, "structure"_a,
             nb::sig("def nodes_to_fit(structure: Structure) -> "
                     "tuple[numpy.typing.NDArray[numpy.int64], numpy.typing.NDArray[numpy.int64]]"),
             "The atom of each residue of a polymer (CA, P), and the number of its chain.");
  module.def(
      "outward_places", &outward_places, "structure"_a,
      nb::sig("def outward_places(structure: Structure) -> "
              "numpy.typing.NDArray[numpy.float64]"),
      "(M, 3) a place 1 Angstrom from each alpha carbon towards the beta carbon: (a, b, c) of"
      "\na u + b v + c u x v, where u and v lead to the next and to the previous alpha "
      "carbon.\n0 at ends of chains and for nucleotides.");
  module.def(
      "fit_nodes", &fitted, "starts"_a, "chains"_a, "pairs"_a, "low"_a, "high"_a, "local"_a,
      "density"_a = nb::none(), "stages"_a = std::size(fit_weights),
      nb::sig("def fit_nodes(starts: numpy.typing.NDArray[numpy.float64], "
              "chains: numpy.typing.ArrayLike, pairs: numpy.typing.ArrayLike, "
              "low: numpy.typing.ArrayLike, high: numpy.typing.ArrayLike, "
              "local: numpy.typing.NDArray[numpy.float64], "
              "density: DensityData | None = None, stages: int = 4) -> "
              "tuple[numpy.typing.NDArray[numpy.float64], "
              "numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]"),
      "Fits nodes from each start (F, M, 3) to the distances of pairs (K, 2) of them, or of "
      "places\n`local` (K, 2, 3) beside them, as outward_places() gives these, each "
      "from low (K)\nto high (K), Angstrom, and to a density; data count more in each of four "
      "stages. Returns the fitted nodes, and of each fit the "
      "strain and the misfit.");
}

}  // namespace pliant::python
