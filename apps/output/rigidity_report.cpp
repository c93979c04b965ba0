// SPDX-License-Identifier: MIT
#include "output/rigidity_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "output/csv_cell.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/model/prepare/survey.hpp"
#include "pliant/model/rigidity/dilution_picture.hpp"

namespace pliant::app {
namespace {

constexpr std::size_t most_printed = 10, most_stretches = 6;

void print_row(std::string_view label, std::size_t value, const std::string& comment) {
  fmt::print("{:<28}{:>9}{}{}\n", label, value, comment.empty() ? "" : "   ", comment);
}

std::string percent(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : fmt::format("{:.0f} %", 100.0 * double(part) / double(whole));
}

std::string counted_contacts(const RigidityReport& report) {
  std::map<std::string, std::size_t> counts;
  const std::size_t edges = report.rigidity.network.edges.size();
  for (std::size_t k = report.rigidity.network.bonds; k < edges; ++k) ++counts[report.kind_of(k)];
  std::string text;
  for (const auto& [kind, count] : counts)
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", kind, count);
  return text;
}

void print_totals(const RigidityReport& report) {
  const Rigidity& rigidity = report.rigidity;
  const RigidClusters& found = rigidity.found;
  fmt::print("{}\n", printable_name(report.file));
  print_row("atoms", rigidity.network.atoms,
            fmt::format("{} residues", report.model.structure.atoms.residues.size()));
  print_row("contacts", rigidity.network.edges.size() - rigidity.network.bonds,
            counted_contacts(report));
  print_row("bonds that may turn", rigidity.hinges,
            fmt::format("{} flexible, {} locked by rings and contacts", rigidity.flexible_bonds,
                        rigidity.hinges - rigidity.flexible_bonds));
  print_row("internal degrees of freedom", found.freedoms,
            found.components == 1
                ? std::string("all is linked")
                : fmt::format("of {} parts that nothing links", found.components));
  print_row("constraints", found.bars, fmt::format("{} redundant", report.redundant_bars()));
  print_row("rigid clusters", report.listed_clusters(),
            fmt::format("of {} atoms or more; {} of the atoms", least_cluster,
                        percent(report.atoms_in_listed(), rigidity.network.atoms)));
  print_row("small pieces", found.clusters.small_pieces(), "of one or two atoms");
}

void print_clusters(const RigidityReport& report) {
  const std::size_t count = std::min(report.listed_clusters(), most_printed);
  if (count == 0) return;
  fmt::print("\n{:>7} {:>7} {:>6}  {}\n", "cluster", "atoms", "share", "residues");
  for (std::size_t k = 0; k < count; ++k) {
    const std::uint32_t size = report.rigidity.found.clusters.sizes[k];
    fmt::print("{:>7} {:>7} {:>6}  {}\n", k + 1, size, percent(size, report.rigidity.network.atoms),
               residues_of(report, static_cast<std::uint32_t>(k), most_stretches));
  }
}

bool breaks_something(const DilutionRow& before, const DilutionRow& row) {
  return before.clusters != row.clusters || before.largest != row.largest;
}

void print_dilution(const RigidityReport& report) {
  const auto& rows = report.dilution;
  if (rows.empty()) return;
  fmt::print("\nHydrogen bonds taken out, the weakest first; rows where clusters change\n");
  fmt::print("{:>6} {:>9} {:>8} {:>9} {:>8}  {:<20}  {}\n", "left", "kcal/mol", "freedom",
             "redundant", "clusters", "largest (atoms)", "taken out");
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (k > 0 && k + 1 < rows.size() && !breaks_something(rows[k - 1], rows[k])) continue;
    std::string sizes;
    for (std::size_t n = 0; n < 3; ++n) sizes += fmt::format("{:>6} ", rows[k].largest[n]);
    const auto weakest = report.weakest_of(rows[k]);
    std::string taken;
    if (const auto edge = report.taken_for(k)) {
      const BodyEdge& at = report.rigidity.network.edges[*edge];
      taken = report.label(at.a) + " " + report.label(at.b);
    }
    fmt::print("{:>6} {:>9} {:>8} {:>9} {:>8}  {:<20}  {}\n", rows[k].hydrogen_bonds,
               weakest ? fmt::format("{:.2f}", *weakest) : "-", rows[k].freedoms, rows[k].redundant,
               rows[k].clusters, sizes, printable(taken));
  }
}

}  // namespace

bool RigidityReport::is_listed_bond(std::size_t edge) const {
  return !rigidity.network.is_bond(edge) || rigidity.network.edges[edge].bars < freedoms_of_body ||
         rigidity.found.redundant[edge] > 0;
}

std::size_t RigidityReport::coloured_clusters() const {
  return pliant::coloured_clusters(model.structure, rigidity.found.clusters);
}

bool RigidityReport::is_polymer() const {
  return usual_model(model.structure) == ModelKind::protein;
}

std::size_t RigidityReport::atoms_in_listed() const {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < listed_clusters(); ++k) sum += rigidity.found.clusters.sizes[k];
  return sum;
}

std::size_t RigidityReport::redundant_bars() const {
  return rigidity.found.bars - rigidity.found.rank;
}

std::string RigidityReport::kind_of(std::size_t edge) const {
  if (rigidity.network.is_bond(edge)) return "bond";
  return std::string(name(model.contacts[rigidity.network.contact_of(edge)].kind));
}

std::optional<double> RigidityReport::energy_of(std::size_t edge) const {
  if (rigidity.network.is_bond(edge)) return std::nullopt;
  return model.contacts[rigidity.network.contact_of(edge)].energy;
}

std::optional<double> RigidityReport::weakest_of(const DilutionRow& row) const {
  if (row.hydrogen_bonds == 0) return std::nullopt;
  const std::size_t last = rigidity.network.first_hydrogen_bond + row.hydrogen_bonds - 1;
  return model.contacts[rigidity.network.contact_of(last)].energy;
}

std::optional<std::size_t> RigidityReport::taken_for(std::size_t row) const {
  if (row == 0) return std::nullopt;
  return rigidity.network.first_hydrogen_bond + dilution[row].hydrogen_bonds;
}

std::string insertion_of(const Residue& residue) {
  return residue.insertion_code > ' ' ? std::string(1, residue.insertion_code) : "";
}

std::string residues_of(const RigidityReport& report, std::uint32_t cluster, std::size_t most) {
  const AtomTable& atoms = report.model.structure.atoms;
  const auto& of_atom = report.rigidity.found.clusters.of_body;
  std::vector<std::uint32_t> counts(atoms.residues.size(), 0);
  for (std::size_t atom = 0; atom < of_atom.size(); ++atom)
    if (of_atom[atom] == cluster) ++counts[atoms.residue_of[atom]];
  std::string text;
  std::size_t stretches = 0;
  for (std::size_t r = 0; r < counts.size(); ++r) {
    if (counts[r] < least_cluster) continue;
    const std::size_t first = r;
    while (r + 1 < counts.size() && counts[r + 1] >= least_cluster &&
           atoms.residues[r + 1].chain == atoms.residues[first].chain)
      ++r;
    if (stretches++ == most) return text + ", ...";
    const Residue& residue = atoms.residues[first];
    text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", printable(residue.chain),
                        residue.chain.empty() ? "" : ":", residue.number);
    if (r > first) text += fmt::format("-{}", atoms.residues[r].number);
  }
  return text;
}

void print_rigidity(const RigidityReport& report) {
  print_totals(report);
  print_clusters(report);
  print_dilution(report);
}

std::string residues_as_csv(const RigidityReport& report) {
  std::string text = "chain,number,insertion,name,cluster,flexibility,bonds,flexible\n";
  const auto& residues = report.model.structure.atoms.residues;
  for (std::size_t k = 0; k < residues.size(); ++k) {
    const ResidueFlexibility& found = report.rigidity.residues[k];
    text += fmt::format("{},{},{},{},{},{:.6g},{},{}\n", csv_cell(residues[k].chain),
                        residues[k].number, csv_cell(insertion_of(residues[k])),
                        csv_cell(residues[k].name), found.cluster + 1, found.index, found.bonds,
                        found.flexible);
  }
  return text;
}

std::string bonds_as_csv(const RigidityReport& report) {
  std::string text = "kind,a,b,bars,redundant,flexible,flexibility,energy\n";
  const Rigidity& rigidity = report.rigidity;
  for (std::size_t k = 0; k < rigidity.network.edges.size(); ++k) {
    if (!report.is_listed_bond(k)) continue;
    const BodyEdge& edge = rigidity.network.edges[k];
    const auto energy = report.energy_of(k);
    text += fmt::format("{},{},{},{},{},{},{:.6g},{}\n", report.kind_of(k),
                        csv_cell(report.label(edge.a)), csv_cell(report.label(edge.b)), edge.bars,
                        rigidity.found.redundant[k], int(rigidity.is_flexible(k)),
                        rigidity.flexibility[k], energy ? fmt::format("{:.6g}", *energy) : "");
  }
  return text;
}

std::string dilution_as_csv(const RigidityReport& report) {
  std::string text =
      "hydrogen_bonds,cutoff,degrees_of_freedom,redundant,clusters,largest,second,third,a,b\n";
  for (std::size_t k = 0; k < report.dilution.size(); ++k) {
    const DilutionRow& row = report.dilution[k];
    const auto weakest = report.weakest_of(row);
    const auto taken = report.taken_for(k);
    const auto end = [&](std::uint32_t BodyEdge::*place) {
      return taken ? csv_cell(report.label(report.rigidity.network.edges[*taken].*place)) : "";
    };
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", row.hydrogen_bonds,
                        weakest ? fmt::format("{:.6g}", *weakest) : "", row.freedoms, row.redundant,
                        row.clusters, row.largest[0], row.largest[1], row.largest[2],
                        end(&BodyEdge::a), end(&BodyEdge::b));
  }
  return text;
}

}  // namespace pliant::app
