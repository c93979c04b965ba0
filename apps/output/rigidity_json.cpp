// SPDX-License-Identifier: MIT
#include "output/rigidity_json.hpp"

#include "pliant/base/elements.hpp"
#include "pliant/model/rigidity/dilution_picture.hpp"

namespace pliant::app {
namespace {

Json json_of_clusters(const RigidityReport& report) {
  std::vector<Json> clusters;
  const std::size_t coloured = report.coloured_clusters();
  for (std::size_t k = 0; k < report.listed_clusters(); ++k) {
    const Json row{{"cluster", k + 1},
                   {"atoms", report.rigidity.found.clusters.sizes[k]},
                   {"residues", residues_of(report, static_cast<std::uint32_t>(k), ~0U)}};
    clusters.push_back(k < coloured ? row + Json{{"colour", cluster_colour(k)}} : row);
  }
  return Json::array(clusters);
}

Json json_of_bonds(const RigidityReport& report) {
  std::vector<Json> bonds;
  const Rigidity& rigidity = report.rigidity;
  for (std::size_t k = 0; k < rigidity.network.edges.size(); ++k) {
    if (!report.is_listed_bond(k)) continue;
    const BodyEdge& edge = rigidity.network.edges[k];
    const Json row{{"kind", report.kind_of(k)},
                   {"a", report.label(edge.a)},
                   {"b", report.label(edge.b)},
                   {"bars", edge.bars},
                   {"redundant", rigidity.found.redundant[k]},
                   {"flexible", rigidity.is_flexible(k)},
                   {"flexibility", rigidity.flexibility[k]}};
    const auto energy = report.energy_of(k);
    bonds.push_back(energy ? row + Json{{"energy", *energy}} : row);
  }
  return Json::array(bonds);
}

Json json_of_residues(const RigidityReport& report) {
  std::vector<Json> rows;
  const auto& residues = report.model.structure.atoms.residues;
  for (std::size_t k = 0; k < residues.size(); ++k) {
    const ResidueFlexibility& found = report.rigidity.residues[k];
    rows.push_back({{"chain", residues[k].chain},
                    {"number", residues[k].number},
                    {"insertion", insertion_of(residues[k])},
                    {"name", residues[k].name},
                    {"cluster", found.cluster + 1},
                    {"flexibility", found.index},
                    {"bonds", found.bonds},
                    {"flexible", found.flexible}});
  }
  return Json::array(rows);
}

Json json_of_dilution(const RigidityReport& report) {
  std::vector<Json> rows;
  for (std::size_t k = 0; k < report.dilution.size(); ++k) {
    const DilutionRow& row = report.dilution[k];
    std::vector<Json> largest;
    for (const std::uint32_t size : row.largest) largest.push_back(size);
    Json json{{"hydrogen_bonds", row.hydrogen_bonds},
              {"degrees_of_freedom", row.freedoms},
              {"redundant", row.redundant},
              {"clusters", row.clusters},
              {"largest", Json::array(largest)}};
    if (const auto taken = report.taken_for(k)) {
      const BodyEdge& edge = report.rigidity.network.edges[*taken];
      json = json + Json{{"a", report.label(edge.a)}, {"b", report.label(edge.b)}};
    }
    if (const auto weakest = report.weakest_of(row)) json = json + Json{{"cutoff", *weakest}};
    rows.push_back(std::move(json));
  }
  return Json::array(rows);
}

Json json_of_structure(const Structure& structure) {
  std::vector<std::string> names, elements;
  std::vector<Json> residue_of, positions, bonds;
  for (std::size_t k = 0; k < structure.positions.size(); ++k) {
    names.push_back(std::string(structure.atoms.names[k]));
    elements.push_back(std::string(element_symbol(structure.atoms.elements[k])));
    residue_of.push_back(structure.atoms.residue_of[k]);
    const Vec3& at = structure.positions[k];
    for (const double coordinate : {at.x, at.y, at.z}) positions.push_back(coordinate);
  }
  for (const Bond& bond : structure.bonds)
    for (const std::uint32_t atom : {bond.a, bond.b}) bonds.push_back(atom);
  return {{"names", names},
          {"elements", elements},
          {"residue_of_atom", Json::array(residue_of)},
          {"positions", Json::array(positions)},
          {"atoms_of_bonds", Json::array(bonds)}};
}

}  // namespace

Json json_of_rigidity(const RigidityReport& report) {
  const RigidClusters& found = report.rigidity.found;
  std::vector<Json> of_atom;
  for (const std::uint32_t cluster : found.clusters.of_body) of_atom.push_back(cluster + 1);
  const Json totals{
      {"file", report.file},
      {"atoms", report.rigidity.network.atoms},
      {"contacts", report.rigidity.network.edges.size() - report.rigidity.network.bonds},
      {"bonds_that_may_turn", report.rigidity.hinges},
      {"flexible_bonds", report.rigidity.flexible_bonds},
      {"degrees_of_freedom", found.freedoms},
      {"parts", found.components},
      {"bars", found.bars},
      {"redundant", report.redundant_bars()},
      {"rigid_clusters", report.listed_clusters()},
      {"coloured_clusters", report.coloured_clusters()},
      {"small_pieces", found.clusters.small_pieces()},
      {"rings_of_six", report.rigidity.rings_of_six}};
  const Json lists{{"clusters", json_of_clusters(report)},
                   {"cluster_of_atom", Json::array(of_atom)},
                   {"residues", json_of_residues(report)},
                   {"bonds", json_of_bonds(report)}};
  if (report.dilution.empty()) return totals + lists;
  return totals + lists + Json{{"dilution", json_of_dilution(report)}};
}

Json json_for_page(const RigidityReport& report) {
  return json_of_rigidity(report) + json_of_structure(report.model.structure) +
         Json{{"dilution_svg", report.dilution_svg}};
}

}  // namespace pliant::app
