// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/gathering.hpp"

#include <algorithm>
#include <string>

#include "pliant/molecule/structure/residue_order.hpp"

namespace pliant {
namespace {

/// Residues of what were runs; `run_of` are the runs of their first atoms.
void take_runs(AtomSites& sites, const std::vector<std::uint32_t>& run_of) {
  std::vector<Residue> residues;
  std::vector<std::uint32_t> sections;
  for (const std::uint32_t run : run_of) {
    residues.push_back(sites.structure.atoms.residues[run]);
    if (!sites.sections.empty()) sections.push_back(sites.sections[run]);
  }
  sites.structure.atoms.residues = std::move(residues);
  sites.sections = std::move(sections);
}

void end_chains(AtomSites& sites) {
  if (sites.ended_sections == 0) return;
  const std::vector<std::uint32_t>& sections = sites.sections;
  std::vector<bool>& ends = sites.structure.chain_end;
  ends.clear();
  for (std::size_t r = 0; r + 1 < sections.size(); ++r)
    ends.push_back(sections[r] != sections[r + 1]);
  if (!sections.empty()) ends.push_back(sections.back() < sites.ended_sections);
}

void warn_of_distances(const AtomSites& sites, const std::vector<std::uint32_t>& atoms,
                       Remarks& remarks) {
  if (atoms.empty()) return;
  remarks.warn("residue by distance", sites.lines[atoms[0]], [&] {
    return "several residues have the name of " + sites.structure.atoms.label(atoms[0]) +
           ", and parts of them stand apart: " + std::to_string(atoms.size()) +
           " atoms are assigned to their residues by distance";
  });
}

}  // namespace

void move_atoms(AtomSites& sites, const std::vector<std::uint32_t>& order) {
  reorder_atoms(sites.structure, order);
  reorder(sites.conformers, order);
  reorder(sites.occupancies, order);
  reorder(sites.lines, order);
  reorder(sites.instance_of, order);
}

std::vector<std::uint32_t> gather_residues(AtomSites& sites, Remarks& remarks) {
  AtomTable& atoms = sites.structure.atoms;
  ResidueOrder made = order_residues({atoms, sites.structure.positions, sites.conformers,
                                      sites.segments, sites.sections, sites.unnumbered});
  warn_of_distances(sites, made.by_distance, remarks);
  std::vector<std::uint32_t> run_of;
  for (const std::uint32_t atom : made.leaders) run_of.push_back(atoms.residue_of[atom]);
  take_runs(sites, run_of);
  end_chains(sites);
  atoms.residue_of = std::move(made.residue_of);
  if (std::is_sorted(made.order.begin(), made.order.end())) return {};
  move_atoms(sites, made.order);
  return std::move(made.order);
}

void tell_of_order(AtomSites& sites, const std::vector<std::uint32_t>& listed, Remarks& remarks) {
  if (std::is_sorted(listed.begin(), listed.end())) return;
  std::size_t first = 0;  // atom that stands before one listed earlier
  for (std::size_t k = listed.size(), least = k; k-- > 0;) {
    if (listed[k] > least) first = k;
    least = std::min<std::size_t>(least, listed[k]);
  }
  std::vector<std::uint32_t> sorted = listed;
  std::sort(sorted.begin(), sorted.end());
  for (const std::uint32_t at : listed)
    sites.structure.source_order.push_back(static_cast<std::uint32_t>(
        std::lower_bound(sorted.begin(), sorted.end(), at) - sorted.begin()));
  remarks.note("order", sites.lines[first], [&] {
    return "atom " + sites.structure.atoms.label(first) +
           " stands apart from its residue or chain: atoms of each are put together, in another "
           "order than that of the file";
  });
}

}  // namespace pliant
