// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/survey.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/elements.hpp"
#include "pliant/base/words.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/confidence.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"

namespace pliant {
namespace {

/// Looks at a structure residue by residue.
class Surveyor {
 public:
  explicit Surveyor(const Structure& structure)
      : structure_(structure),
        atoms_(structure.atoms),
        graph_(structure),
        residues_(structure.atoms) {}

  Survey survey() {
    for (std::uint32_t r = 0; r < atoms_.residues.size(); ++r) look_at(r);
    const std::size_t amino_acids = found_.amino_acids;
    found_.is_ca_only = amino_acids > 0 && of_ca_only_ == amino_acids;
    found_.is_backbone_only =
        with_backbone_ > 0 && with_side_chain_ == 0 && amino_acids > glycines_;
    if (found_.is_backbone_only || found_.is_ca_only) found_.incomplete.clear();
    for (const Bond& bond : structure_.bonds)
      if (atoms_.elements[bond.a] == 16 && atoms_.elements[bond.b] == 16)
        found_.disulphides.push_back(bond);
    found_.has_confidence = has_confidences(structure_);
    return std::move(found_);
  }

 private:
  void look_at(std::uint32_t r) {
    const Residue& residue = atoms_.residues[r];
    const std::size_t hydrogens = hydrogens_of(r);
    found_.hydrogens += hydrogens;
    if (is_water(residue)) {
      ++found_.waters;
    } else if (is_amino_acid(residue) || is_nucleotide(residue)) {
      ++(is_nucleotide(residue) ? found_.nucleotides : found_.amino_acids);
      if (hydrogens == 0) found_.without_hydrogens.push_back(r);
      if (is_amino_acid(residue)) look_at_amino_acid(r);
    } else if (!is_cap(residue)) {
      look_at_other(r);
    }
    if (r > 0 && is_break(r - 1, r)) found_.breaks.push_back({r - 1, r});
  }

  std::size_t hydrogens_of(std::uint32_t r) const {
    return static_cast<std::size_t>(std::count(atoms_.elements.begin() + residues_.begin(r),
                                               atoms_.elements.begin() + residues_.end(r), 1));
  }

  void look_at_amino_acid(std::uint32_t r) {
    if (has(r, "N") && has(r, "C")) ++with_backbone_;
    if (residues_.end(r) - residues_.begin(r) == 1 && has(r, "CA")) ++of_ca_only_;
    const std::string_view standard = standard_name(atoms_.residues[r].name);
    if (standard == "GLY") ++glycines_;
    std::string missing;
    const Words names = words_of(side_chain_atoms(standard));
    for (std::string_view name : names)
      if (!has(r, name) && !(name == "CD1" && standard == "ILE" && has(r, "CD")))
        missing += (missing.empty() ? "" : " ") + std::string(name);
    const bool lacks_all = !names.empty() && !has(r, names.front());
    if (!names.empty() && !lacks_all) ++with_side_chain_;
    if (!missing.empty()) found_.incomplete.push_back({r, missing});
  }

  void look_at_other(std::uint32_t r) {
    const std::uint32_t first = residues_.begin(r);
    const bool is_single = residues_.end(r) - first == 1;
    if (has(r, "N") && has(r, "CA") && has(r, "C")) return found_.modified.push_back(r);
    if (!is_single) return found_.ligands.push_back(r);
    (is_metal(atoms_.elements[first]) ? found_.metals : found_.ions).push_back(r);
  }

  bool has(std::uint32_t r, std::string_view name) const {
    return residues_.find(r, name) != no_atom;
  }

  /// Whether two residues should be joined by a peptide or phosphate bond, and are not.
  bool is_break(std::uint32_t before, std::uint32_t after) const {
    if (atoms_.residues[before].chain != atoms_.residues[after].chain) return false;
    if (!structure_.chain_end.empty() && structure_.chain_end[before]) return false;
    const bool is_peptide =
        is_amino_acid(atoms_.residues[before]) && is_amino_acid(atoms_.residues[after]);
    const bool is_nucleic =
        is_nucleotide(atoms_.residues[before]) && is_nucleotide(atoms_.residues[after]);
    if (!is_peptide && !is_nucleic) return false;
    const std::uint32_t tail = residues_.find(before, is_peptide ? "C" : "O3'");
    const std::uint32_t head = residues_.find(after, is_peptide ? "N" : "P");
    if (tail == no_atom || head == no_atom) return false;
    return !graph_.are_bonded(tail, head);
  }

  const Structure& structure_;
  const AtomTable& atoms_;
  AtomGraph graph_;
  ResidueAtoms residues_;
  Survey found_;
  std::size_t with_backbone_ = 0, with_side_chain_ = 0, of_ca_only_ = 0, glycines_ = 0;
};

std::string incomplete_text(const AtomTable& atoms, const std::vector<IncompleteResidue>& all) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, all.size()); ++k)
    text += (k > 0 ? ", " : "") + residue_label(atoms, all[k].residue) + " (" + all[k].atoms + ")";
  if (all.size() > most) text += " and " + std::to_string(all.size() - most) + " more";
  return text;
}

std::string breaks_text(const AtomTable& atoms, const std::vector<ChainBreak>& breaks) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(most, breaks.size()); ++k)
    text += (k > 0 ? ", " : "") + residue_label(atoms, breaks[k].before) + " - " +
            residue_label(atoms, breaks[k].after);
  if (breaks.size() > most) text += " and " + std::to_string(breaks.size() - most) + " more";
  return text;
}

}  // namespace

Survey survey(const Structure& structure) { return Surveyor(structure).survey(); }

std::string residue_label(const AtomTable& atoms, std::uint32_t residue) {
  const Residue& r = atoms.residues[residue];
  std::string text = r.chain.empty() ? "" : r.chain + ":";
  text += r.name + std::to_string(r.number);
  if (r.insertion_code != ' ') text += r.insertion_code;
  return text;
}

std::string listed_residues(const AtomTable& atoms, const std::vector<std::uint32_t>& residues,
                            std::size_t most) {
  std::string text;
  for (std::size_t k = 0; k < std::min(most, residues.size()); ++k)
    text += (k > 0 ? ", " : "") + residue_label(atoms, residues[k]);
  if (residues.size() > most) text += " and " + std::to_string(residues.size() - most) + " more";
  return text;
}

std::vector<std::string> found_parts(const Structure& structure, const Survey& survey) {
  std::vector<std::string> lines;
  const auto add = [&](const char* what, const std::vector<std::uint32_t>& residues) {
    if (!residues.empty())
      lines.push_back(std::string(what) + ": " + listed_residues(structure.atoms, residues));
  };
  add("modified residues", survey.modified);
  add("ligands", survey.ligands);
  add("metals", survey.metals);
  add("ions", survey.ions);
  if (!survey.disulphides.empty())
    lines.push_back("disulphides: " + std::to_string(survey.disulphides.size()));
  return lines;
}

std::vector<std::string> missing_parts(const Structure& structure, const Survey& survey) {
  std::vector<std::string> lines;
  const auto count = [](std::size_t n, const char* one, const char* many) {
    return std::to_string(n) + " " + (n == 1 ? one : many);
  };
  if (survey.is_backbone_only)
    lines.push_back("side chains: " + count(survey.amino_acids, "residue has", "residues have") +
                    " the backbone alone");
  if (!survey.incomplete.empty())
    lines.push_back(
        "side chains: " +
        count(survey.incomplete.size(), "residue lacks atoms: ", "residues lack atoms: ") +
        incomplete_text(structure.atoms, survey.incomplete));
  if (!survey.breaks.empty())
    lines.push_back(count(survey.breaks.size(), "chain break: ", "chain breaks: ") +
                    breaks_text(structure.atoms, survey.breaks));
  return lines;
}

std::vector<std::uint32_t> ligands_without_hydrogens(const AtomTable& atoms, const Survey& survey) {
  const ResidueAtoms residues(atoms);
  std::vector<std::uint32_t> bare;
  for (std::uint32_t r : survey.ligands) {
    const auto first = atoms.elements.begin();
    const auto begin = first + residues.begin(r), end = first + residues.end(r);
    const bool is_polar = std::any_of(begin, end, [](std::uint8_t e) { return e == 7 || e == 8; });
    if (is_polar && std::find(begin, end, 1) == end) bare.push_back(r);
  }
  return bare;
}

std::vector<double> residue_b_factors(const Structure& structure) {
  std::vector<double> sums(structure.atoms.residues.size(), 0.0), counts(sums.size(), 0.0);
  for (std::size_t i = 0; i < structure.b_factors.size(); ++i) {
    sums[structure.atoms.residue_of[i]] += static_cast<double>(structure.b_factors[i]);
    counts[structure.atoms.residue_of[i]] += 1.0;
  }
  for (std::size_t r = 0; r < sums.size(); ++r)
    if (counts[r] > 0.0) sums[r] /= counts[r];
  return sums;
}

}  // namespace pliant
