// SPDX-License-Identifier: MIT
// The report of pliant rigidity: a table to read, and CSV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/jobs/rigidity_task.hpp"
#include "pliant/model/rigidity/rigidity_dilution.hpp"

namespace pliant::app {

/// All that was found of one molecule.
struct RigidityReport : MoleculeRigidity {
  std::string file;
  std::vector<DilutionRow> dilution;  ///< none was asked for: empty
  std::string dilution_svg;           ///< its picture; "": none

  std::size_t listed_clusters() const { return rigidity.found.clusters.count(); }
  std::size_t coloured_clusters() const;  ///< number of clusters with a colour
  bool is_polymer() const;                ///< whether it has chains of amino acids
  std::size_t atoms_in_listed() const;
  std::size_t redundant_bars() const;
  /// The name of a kind of contact, or "bond".
  std::string kind_of(std::size_t edge) const;
  /// Whether an edge could turn, or has redundant bars.
  bool is_listed_bond(std::size_t edge) const;
  /// kcal/mol; nothing for a bond
  std::optional<double> energy_of(std::size_t edge) const;
  std::string label(std::uint32_t atom) const { return model.structure.atoms.label(atom); }
  /// The energy of the weakest hydrogen bond left in a row; nothing if none is left.
  std::optional<double> weakest_of(const DilutionRow& row) const;
  /// The hydrogen bond removed since the row before; nothing for the first row.
  std::optional<std::size_t> taken_for(std::size_t row) const;
};

/// The insertion code as text; "" if there is none.
std::string insertion_of(const Residue& residue);

/// "A:1-20, A:25": residues with three atoms or more in a cluster; at most `most` ranges.
std::string residues_of(const RigidityReport& report, std::uint32_t cluster, std::size_t most);

void print_rigidity(const RigidityReport& report);
/// One line for each residue.
std::string residues_as_csv(const RigidityReport& report);
/// One line for each bond or contact that could turn or has redundant bars.
std::string bonds_as_csv(const RigidityReport& report);
/// One line for each hydrogen bond removed.
std::string dilution_as_csv(const RigidityReport& report);

}  // namespace pliant::app
