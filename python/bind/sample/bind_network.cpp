// SPDX-License-Identifier: MIT
// Elastic networks: their table, their modes, and the B factors that they give.
#include "arrays.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/error.hpp"
#include "pliant/sample/network/b_factors.hpp"
#include "pliant/sample/network/mode_field.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "sample/network_nodes.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

nb::tuple modes_of(const nb::handle& structure, const std::string& network, std::size_t count) {
  const nb::object given = structure_from(structure);
  const auto& from = nb::cast<const Structure&>(given);
  const NetworkNodes nodes = nodes_of(from);
  check(nodes, from.size());
  const NetworkModes modes = network_modes(nodes, network, count);
  std::vector<Vec3> directions;
  for (std::size_t k = 0; k < modes.variances.size(); ++k) {
    const std::span<const double> row = modes.directions.row(k);
    for (std::size_t i = 0; i < row.size(); i += 3)
      directions.push_back({row[i], row[i + 1], row[i + 2]});
  }
  return nb::make_tuple(
      array_of(modes.variances),
      new_frames(std::move(directions), modes.variances.size(), nodes.positions.size()),
      new_positions(nodes.positions));
}

/// Residues alone: waters are everywhere in crystals, and ligands are no part of the chain.
nb::tuple b_factors_of(const nb::handle& structure) {
  const nb::object given = structure_from(structure);
  const auto& from = nb::cast<const Structure&>(given);
  const ResidueNodes found = residue_nodes(from);
  NetworkNodes nodes;
  std::vector<std::int64_t> atoms;
  for (std::size_t k = 0; k < found.positions.size(); ++k) {
    if (!found.is_residue[k]) continue;
    nodes.positions.push_back(found.positions[k]);
    nodes.chain.push_back(found.chain[k]);
    atoms.push_back(found.atom[k]);
  }
  check(nodes, 0);
  return nb::make_tuple(array_of(relative_b_factors(nodes)), array_of(atoms));
}

/// Chains by equal numbers that follow each other.
std::vector<std::uint32_t> chains_from(const OptionalArray& chains, std::size_t count) {
  std::vector<std::uint32_t> out(count, 0);
  if (!chains) return out;
  const std::vector<std::int64_t> given = integers_from(*chains, "chains");
  if (given.size() != count)
    throw InputError("chains: expected " + std::to_string(count) +
                     ", one for each position, found " + std::to_string(given.size()));
  for (std::size_t k = 1; k < count; ++k) out[k] = out[k - 1] + (given[k] != given[k - 1]);
  return out;
}

nb::object b_factors_at(const ArrayLike& positions, const OptionalArray& chains) {
  NetworkNodes nodes;
  nodes.positions = positions_from(positions);
  nodes.chain = chains_from(chains, nodes.positions.size());
  check(nodes, 0);
  return nb::cast(array_of(relative_b_factors(nodes)));
}

PositionsView field_of(const nb::handle& structure, std::int64_t mode, double amplitude,
                       const std::string& network) {
  const nb::object given = structure_from(structure);
  const auto& from = nb::cast<const Structure&>(given);
  if (mode < 1) throw OptionError("mode = " + std::to_string(mode) + ": must be from 1");
  return new_positions(mode_field(nodes_of(from), from.positions, static_cast<std::size_t>(mode),
                                  amplitude, network));
}

constexpr const char* field_doc =
    R"(The displacement of all atoms along one mode of the elastic network of a structure.

Parameters
----------
structure : Structure
mode : int
    From 1, the mode of largest variance.
amplitude : float
    r.m.s. displacement of the nodes, Angstrom.
network : str
    A name in ``networks()``.

Returns
-------
(N, 3) float64
    Angstrom. Atoms go and turn with their residues, as frames of ``sample`` do.

Raises
------
OptionError
    No such mode or network, or fewer than two nodes.
)";

constexpr const char* modes_doc =
    R"(Modes of the elastic network of a structure.

Parameters
----------
structure : Structure
network : str
    A name in ``networks()``.
count : int
    How many modes, of largest variance first.

Returns
-------
variances : (K,) float64
    Descending, in the unit of 1 / the springs; of ``shared``, shares of the whole.
directions : (K, M, 3) float64
    Of unit length, signs canonical.
nodes : (M, 3) float64
    Where the nodes are (Angstrom).

Raises
------
OptionError
    No such network, or fewer than two nodes.
)";

constexpr const char* b_factors_doc =
    R"(Crystal B factors from an elastic network, relative to their mean.

They show which residues should be flexible relative to others in a crystal; absolute B factors
depend on the crystal. They are the diagonal of the pseudoinverse of Kirchhoff's matrix (Gaussian
network model: Bahar, Atilgan, Erman, Fold. Des. 2 (1997) 173) of the springs of network
``shared``, and no average over an ensemble. Waters and ligands are left out.

Parameters
----------
structure : Structure

Returns
-------
values : (K,) float64
    One for each amino acid or nucleotide; their mean is 1. Above 3000, neighbours share one.
atoms : (K,) int64
    The atom of each: CA, or P (C4' where there is none).

Raises
------
OptionError
    Fewer than two amino acids or nucleotides.
InputError
    A position is not finite.
)";

constexpr const char* b_factors_at_doc =
    R"(``estimate_b_factors`` of nodes that are given, such as alpha carbons.

Parameters
----------
positions : (M, 3) array-like
    Angstrom; along the chains.
chains : (M,) array-like of int, optional
    Nodes of one chain follow each other and have the same number. None: one chain. Neighbours
    further apart than residues can be are not joined.

Returns
-------
(M,) float64
    Relative to their mean.

Raises
------
OptionError
    Fewer than two nodes.
InputError
    An array has another shape, or a position is not finite.
)";

}  // namespace

void bind_network(nb::module_& module) {
  bind_row<NetworkEntry>(module, "NetworkEntry", "One row of the table of elastic networks.");
  module.def(
      "networks", [] { return rows_of(networks()); }, nb::rv_policy::reference,
      "The table of elastic networks that ``sample`` knows.");
  module.def(
      "network_modes", &modes_of, "structure"_a, "network"_a = "shared",
      "count"_a = usual_mode_count,
      nb::sig("def network_modes(structure: Structure | Molecule, network: str = \"shared\", "
              "count: int = 60) -> tuple[numpy.typing.NDArray[numpy.float64], "
              "numpy.typing.NDArray[numpy.float64], numpy.typing.NDArray[numpy.float64]]"),
      modes_doc);
  module.def(
      "mode_field", &field_of, "structure"_a, "mode"_a, "amplitude"_a = 1.0, "network"_a = "shared",
      nb::sig("def mode_field(structure: Structure | Molecule, mode: int, amplitude: float = 1.0, "
              "network: str = \"shared\") -> numpy.typing.NDArray[numpy.float64]"),
      field_doc);
  module.def("estimate_b_factors", &b_factors_of, "structure"_a,
             nb::sig("def estimate_b_factors(structure: Structure | Molecule) -> "
                     "tuple[numpy.typing.NDArray[numpy.float64], "
                     "numpy.typing.NDArray[numpy.int64]]"),
             b_factors_doc);
  module.def("node_b_factors", &b_factors_at, "positions"_a, "chains"_a = nb::none(),
             nb::sig("def node_b_factors(positions: numpy.typing.ArrayLike, "
                     "chains: numpy.typing.ArrayLike | None = None) -> "
                     "numpy.typing.NDArray[numpy.float64]"),
             b_factors_at_doc);
}

}  // namespace pliant::python
