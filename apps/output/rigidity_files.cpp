// SPDX-License-Identifier: MIT
#include "output/rigidity_files.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "output/rigidity_scripts.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/record/pdb_text.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant::app {
namespace {

constexpr double most_b_factor = 999.0, least_b_factor = -99.99;

/// 1 is the largest; 0 for those that are not listed or whose number does not fit the column.
std::vector<double> cluster_numbers(const RigidityReport& report) {
  std::vector<double> values;
  const auto listed = static_cast<double>(report.listed_clusters());
  for (const std::uint32_t cluster : report.rigidity.found.clusters.of_body) {
    const double number = cluster + 1.0;
    values.push_back(number <= std::min(listed, most_b_factor) ? number : 0.0);
  }
  return values;
}

std::vector<double> flexibility_of_atoms(const RigidityReport& report) {
  std::vector<double> values;
  for (const std::uint32_t residue : report.model.structure.atoms.residue_of)
    values.push_back(std::max(100.0 * report.rigidity.residues[residue].index, least_b_factor));
  return values;
}

std::string pdb_of(const RigidityReport& report, const std::string& remark,
                   const std::vector<double>& b_factors, PdbCuts& cuts) {
  const Structure& structure = report.model.structure;
  PdbText pdb(structure.atoms, false);
  pdb.add_remark(remark);
  pdb.add_atoms(structure.positions, b_factors);
  std::vector<RecordedBond> bonds;
  for (const Bond& bond : structure.bonds)
    bonds.push_back({bond.a, bond.b, static_cast<std::uint8_t>(bond.origin), bond.order});
  pdb.add_bonds(bonds);
  pdb.add_end();
  cuts = pdb.cuts();
  return pdb.text();
}

}  // namespace

std::vector<std::string> rigidity_file_names(bool has_dilution) {
  std::vector<std::string> names{"clusters.pdb", "flexibility.pdb", "show.pml",
                                 "show.cxc",     "residues.csv",    "bonds.csv"};
  if (has_dilution) names.insert(names.end(), {"dilution.csv", "dilution.svg"});
  return names;
}

void write_rigidity_folder(const std::string& folder, const RigidityReport& report, bool overwrite,
                           const Log& log) {
  const std::filesystem::path path = path_of(folder);
  const bool polymer = report.is_polymer();
  const std::vector<double> flexibility = flexibility_of_atoms(report);
  double most = 1.0;
  for (const double value : flexibility) most = std::max(most, std::ceil(value));
  const std::size_t coloured = report.coloured_clusters();
  PdbCuts cuts;
  std::vector<std::string> texts{
      pdb_of(report, "B = number of the rigid cluster, 1 the largest; 0 in none",
             cluster_numbers(report), cuts),
      pdb_of(report, "B = 100 x flexibility index of the residue", flexibility, cuts),
      rigidity_pymol_script(coloured, polymer, most),
      rigidity_chimerax_script(coloured, polymer, most),
      residues_as_csv(report),
      bonds_as_csv(report)};
  if (!report.dilution.empty())
    texts.insert(texts.end(), {dilution_as_csv(report), report.dilution_svg});
  make_folder(path);
  const auto names = rigidity_file_names(!report.dilution.empty());
  for (std::size_t k = 0; k < names.size(); ++k)
    write_text_file(path / names[k], texts[k], overwrite);
  cuts.tell(path_text(path / names[0]), log);
}

}  // namespace pliant::app
