// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/prepare.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/prepare/additives.hpp"
#include "pliant/model/prepare/carbon_hydrogens.hpp"
#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/model/prepare/hydrogen_places.hpp"
#include "pliant/model/prepare/polar_hydrogens.hpp"
#include "pliant/model/prepare/side_chain_geometry.hpp"
#include "pliant/model/prepare/side_chains.hpp"
#include "pliant/model/prepare/survey.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant {
namespace {

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// A residue of another element that stands for a usual one.
struct Substitute {
  std::string_view residue, becomes, atom, renamed;
};
constexpr Substitute substitutes[] = {{"MSE", "MET", "SE", "SD"}, {"SEC", "CYS", "SE", "SG"}};
constexpr std::uint8_t sulphur = 16;

/// Angstrom: side chains that were built so deep into other atoms are reported.
constexpr double crowded_from = 0.7;

/// Makes a structure ready, one step after the other.
class Preparer {
 public:
  Preparer(const Structure& structure, const PrepareOptions& options)
      : options_(options), has_confidence_(survey(structure).has_confidence) {
    now_.structure = structure;
    now_.origin.resize(structure.size());
    for (std::uint32_t i = 0; i < structure.size(); ++i) now_.origin[i] = i;
  }

  Preparation prepare() {
    take_out_waters();
    take_out_additives();
    take_out_dummies();
    rename_selenium();
    refuse_ca_only();
    if (options_.fill_side_chains) fill_side_chains();
    const bool is_backbone_only = survey(now_.structure).is_backbone_only;
    if (is_backbone_only) add_cb();
    add_hydrogens();
    tell_of_survey(is_backbone_only);
    find_floppy();
    for (const std::string& line : now_.steps) options_.log.detail(line);
    for (const std::string& line : now_.missing) options_.log.warn(line);
    return std::move(now_);
  }

 private:
  const AtomTable& atoms() const { return now_.structure.atoms; }
  void note(std::string line) { now_.steps.push_back(std::move(line)); }

  /// Goes on with an edited structure, origins counted from the first.
  void take(EditedStructure edited) {
    for (std::uint32_t& origin : edited.origin)
      if (origin != no_atom) origin = now_.origin[origin];
    now_.structure = std::move(edited.structure);
    now_.origin = std::move(edited.origin);
  }

  [[noreturn]] void refuse(const std::string& message) const {
    const std::string& source = now_.structure.source;
    throw InputError(source.empty() ? message : at({source}, message));
  }

  template <class Condition>
  std::size_t residues_that(const Condition& holds) const {
    return static_cast<std::size_t>(std::ranges::count_if(atoms().residues, holds));
  }

  template <class Condition>
  void take_out(const Condition& holds) {
    std::vector<bool> is_out(now_.structure.size());
    for (std::size_t i = 0; i < is_out.size(); ++i) is_out[i] = holds(atoms().residue_of[i]);
    take(without_atoms(now_.structure, is_out));
  }

  void take_out(bool (*holds)(const Residue&), const std::string& nothing_but) {
    if (std::ranges::all_of(atoms().residues, holds)) refuse("holds nothing but " + nothing_but);
    take_out([&](std::uint32_t r) { return holds(atoms().residues[r]); });
  }

  void take_out_waters() {
    const std::size_t waters = residues_that(is_water);
    if (waters == 0) return;
    if (options_.keep_waters) return note(counted(waters, "water kept", "waters kept"));
    take_out(is_water, "water");
    now_.left_out.push_back(counted(waters, "water", "waters"));
    note(now_.left_out.back() + " taken out");
  }

  void take_out_additives() {
    const Additives found = find_additives(now_.structure, options_.keep);
    if (!found.at_metals.empty())
      note("kept at metals: " + listed_residues(atoms(), found.at_metals));
    if (found.out.empty()) return;
    now_.left_out.push_back(counted(found.out.size(), "molecule", "molecules") +
                            " of crystallisation: " + counted_names(atoms(), found.out) +
                            " (--keep all keeps them)");
    note("left out: " + now_.left_out.back());
    std::vector<bool> is_out(atoms().residues.size());
    for (std::uint32_t r : found.out) is_out[r] = true;
    take_out([&](std::uint32_t r) { return is_out[r]; });
  }

  /// Those of structures from other packages: no reader of files lets them in.
  void take_out_dummies() {
    const std::size_t dummies = residues_that(is_membrane_dummy);
    if (dummies > 0) take_out(is_membrane_dummy, "dummy atoms");
    if (dummies > 0) note(counted(dummies, "dummy residue", "dummy residues") + " (DUM) taken out");
  }

  void rename_selenium() {
    std::map<std::string_view, std::size_t> counts;
    AtomTable& table = now_.structure.atoms;
    for (std::size_t i = 0; i < table.size(); ++i)
      for (const Substitute& row : substitutes) {
        if (table.residues[table.residue_of[i]].name != row.residue || table.names[i] != row.atom)
          continue;
        table.names[i] = row.renamed;
        table.elements[i] = sulphur;
        ++counts[row.residue];
      }
    for (const Substitute& row : substitutes) {
      for (Residue& residue : table.residues)
        if (residue.name == row.residue) residue.name = row.becomes;
      if (counts[row.residue] > 0)
        note(counted(counts[row.residue], "residue", "residues") + " " + std::string(row.residue) +
             " taken as " + std::string(row.becomes));
    }
  }

  void refuse_ca_only() const {
    if (survey(now_.structure).is_ca_only)
      refuse(
          "holds CA atoms alone: a model of a protein needs N, CA, C and O at least; Pliant has "
          "none of CA, but elastic networks need no more (ANM of ProDy)");
  }

  void fill_side_chains() {
    BuiltSideChains filled = build_side_chains(now_.structure);
    if (!filled.left.empty())
      now_.missing.push_back(
          "side chains that cannot be built: " + listed_residues(atoms(), filled.left) +
          " (N, CA or C is missing, or an atom between atoms that are there)");
    if (filled.built.empty()) {
      if (filled.left.empty()) note("side chains: no atoms were missing");
      return;
    }
    std::vector<std::uint32_t> residues, crowded;
    for (const BuiltSideChain& row : filled.built) {
      residues.push_back(row.residue);
      if (row.overlap > crowded_from) crowded.push_back(row.residue);
    }
    now_.missing.push_back(
        "side chains: atoms of " + counted(residues.size(), "residue", "residues") +
        " built by rule, which is a guess: " + listed_residues(atoms(), residues));
    if (!crowded.empty())
      now_.missing.push_back(
          "side chains: even with the best of the usual torsions these overlap other atoms: " +
          listed_residues(atoms(), crowded));
    take(std::move(filled.edited));
  }

  void add_cb() {
    const ResidueAtoms residues(atoms());
    const auto& x = now_.structure.positions;
    std::vector<NewAtom> added;
    for (std::size_t r = 0; r < atoms().residues.size(); ++r) {
      const Residue& residue = atoms().residues[r];
      if (!is_amino_acid(residue) || standard_name(residue.name) == "GLY") continue;
      const std::uint32_t n = residues.find(r, "N"), ca = residues.find(r, "CA"),
                          c = residues.find(r, "C");
      if (n != no_atom && ca != no_atom && c != no_atom)
        added.push_back({ca, "CB", 6, ideal_cb(x[n], x[ca], x[c])});
    }
    take(with_atoms(now_.structure, added));
    now_.missing.push_back("side chains: none in the file; it is taken as a backbone with " +
                           counted(added.size(), "CB", "CB") + " placed by rule");
  }

  void add_hydrogens() {
    const Protonation protonation = protonation_of(now_.structure, options_.protonate);
    if (!options_.add_hydrogens) return;
    const bool had_hydrogens = std::count(atoms().elements.begin(), atoms().elements.end(), 1) > 0;
    take_out_asked_hydrogens(protonation);
    std::vector<NewAtom> added;
    for (PlacedHydrogen& h : place_polar_hydrogens(now_.structure, protonation))
      added.push_back({h.parent, std::move(h.name), 1, h.position});
    if (had_hydrogens) note("hydrogens of the file kept");
    if (!added.empty())
      note(counted(added.size(), "polar hydrogen", "polar hydrogens") + " placed by rule");
    tell_of_protonation(protonation);
    if (!added.empty()) take(with_atoms(now_.structure, added));
    if (options_.all_hydrogens) add_carbon_hydrogens();
  }

  void add_carbon_hydrogens() {
    std::vector<NewAtom> added;
    for (PlacedHydrogen& h : place_carbon_hydrogens(now_.structure))
      added.push_back({h.parent, std::move(h.name), 1, h.position});
    if (added.empty()) return note("hydrogens on carbon: none was missing");
    note(counted(added.size(), "hydrogen on carbon", "hydrogens on carbon") + " placed by rule");
    take(with_atoms(now_.structure, added));
  }

  /// The polar hydrogens of side chains whose form is asked for: others come in their place.
  void take_out_asked_hydrogens(const Protonation& protonation) {
    const AtomGraph graph(now_.structure);
    std::vector<bool> is_out(now_.structure.size(), false);
    bool any = false;
    for (std::uint32_t i = 0; i < is_out.size(); ++i) {
      if (!graph.is_hydrogen(i) || !protonation.is_asked_for[atoms().residue_of[i]]) continue;
      const std::uint32_t parent = graph.first_heavy(i);
      if (parent == no_atom || is_backbone(atoms().names[parent]) || atoms().elements[parent] == 6)
        continue;
      is_out[i] = any = true;
    }
    if (any) take(without_atoms(now_.structure, is_out));
  }

  /// Histidines, whose form is a guess, and what was asked for or stands in names.
  void tell_of_protonation(const Protonation& protonation) {
    std::map<std::string, std::vector<std::uint32_t>> by_form;
    for (std::uint32_t r = 0; r < protonation.forms.size(); ++r) {
      const std::string& form = protonation.forms[r];
      const std::string_view standard = standard_name(atoms().residues[r].name);
      if (form != standard && form != "CYX") by_form[form].push_back(r);
    }
    for (const auto& [form, residues] : by_form)
      note("protonation " + form + ": " + listed_residues(atoms(), residues));
  }

  void tell_of_survey(bool is_backbone_only) {
    Survey found = survey(now_.structure);
    if (is_backbone_only) found.incomplete.clear();  // it was said already
    for (const std::string& line : found_parts(now_.structure, found)) note("kept " + line);
    tell_of_ligands_without_hydrogens(found);
    for (std::string& line : missing_parts(now_.structure, found)) {
      if (line.starts_with("side chains") && !options_.fill_side_chains)
        line += "; --fill-side-chains builds them";
      now_.missing.push_back(std::move(line));
    }
  }

  void tell_of_ligands_without_hydrogens(const Survey& found) {
    const std::vector<std::uint32_t> bare = ligands_without_hydrogens(atoms(), found);
    if (!bare.empty())
      now_.missing.push_back(
          "hydrogens of " + listed_residues(atoms(), bare) +
          ": none were added; the hydrogen bonds that these ligands give are guessed "
          "from their other atoms");
  }

  void find_floppy() {
    const double below = options_.floppy_below > 0.0 ? options_.floppy_below : disordered_below;
    if (!has_confidence_ && options_.floppy_below == 0.0) return;
    const std::vector<double> confidence = residue_b_factors(now_.structure);
    std::vector<std::uint32_t> low;
    for (std::uint32_t r = 0; r < confidence.size(); ++r)
      if (confidence[r] < below) low.push_back(r);
    if (low.empty()) return;
    const std::string named = counted(low.size(), "residue", "residues") +
                              " with a confidence (B factor) below " + number_text(below) + ": " +
                              listed_residues(atoms(), low);
    if (options_.floppy_below == 0.0) {
      now_.missing.push_back(named + "; --floppy-below 50 leaves out their contacts");
      return;
    }
    note(named + "; their contacts are left out");
    now_.floppy.assign(confidence.size(), false);
    for (std::uint32_t r : low) now_.floppy[r] = true;
  }

  const PrepareOptions& options_;
  bool has_confidence_;  ///< of the file: hydrogens hide it
  Preparation now_;
};

}  // namespace

Preparation prepare(const Structure& structure, const PrepareOptions& options) {
  return Preparer(structure, options).prepare();
}

}  // namespace pliant
