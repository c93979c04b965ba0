// SPDX-License-Identifier: MIT
#include "pliant/model/model.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/atoms/residue_chemistry.hpp"
#include "pliant/model/contacts/contact_file.hpp"
#include "pliant/model/steric_table.hpp"
#include "pliant/model/torsions_of_residues.hpp"
#include "pliant/molecule/bonds/cut_bonds.hpp"

namespace pliant {
namespace {

constexpr std::array table{ModelEntry{.kind = ModelKind::bonds,
                                      .name = "bonds",
                                      .summary = "a bar for each bond: only bond lengths hold",
                                      .bars = BarKind::bonds},
                           ModelEntry{.kind = ModelKind::angles,
                                      .name = "angles",
                                      .summary = "bars for bonds, angles and planar groups",
                                      .bars = BarKind::angles},
                           ModelEntry{.kind = ModelKind::molecule,
                                      .name = "molecule",
                                      .summary = "angles, and atoms keep their distance",
                                      .bars = BarKind::angles,
                                      .is_prepared = true,
                                      .has_sterics = true},
                           ModelEntry{.kind = ModelKind::protein,
                                      .name = "protein",
                                      .summary = "molecule, and contacts such as hydrogen bonds",
                                      .bars = BarKind::angles,
                                      .is_prepared = true,
                                      .has_sterics = true,
                                      .has_contacts = true}};

/// Limits of pairs that have no bar: a bar holds its distance anyhow.
std::vector<Limit> without_barred(std::vector<Limit> limits, const Framework& bars) {
  std::erase_if(limits, [&](const Limit& limit) {
    const auto neighbours = bars.neighbours(limit.a);
    return std::any_of(neighbours.begin(), neighbours.end(),
                       [&](const Incidence& at) { return at.joint == limit.b; });
  });
  return limits;
}

/// Kinds that are to be found: the usual ones, and those that are asked for.
class WantedKinds {
 public:
  explicit WantedKinds(const std::vector<std::string>& asked) {
    for (const auto& row : molecular_contact_kinds()) is_wanted_.push_back(row.is_usual);
    for (const std::string& name : asked)
      is_wanted_[index(choose(molecular_contact_kinds(), "kind of contact", name).kind)] = true;
  }

  bool has(MolecularContactKind kind) const { return is_wanted_[index(kind)]; }

  /// Each once, in the order of kinds.
  std::vector<ContactFinder*> finders() const {
    std::vector<ContactFinder*> found;
    for (const auto& row : molecular_contact_kinds())
      if (has(row.kind) && std::find(found.begin(), found.end(), row.find) == found.end())
        found.push_back(row.find);
    return found;
  }

 private:
  static std::size_t index(MolecularContactKind kind) { return static_cast<std::size_t>(kind); }

  std::vector<bool> is_wanted_;
};

/// "contacts: hydrogen_bond 54, salt_bridge 4, hydrophobic 31, metal 0", and kinds that are not
/// usual where there are any or they were asked for.
std::string note_of_contacts(std::span<const MolecularContact> contacts,
                             const WantedKinds& wanted) {
  std::map<MolecularContactKind, std::size_t> counts;
  for (const MolecularContact& contact : contacts) ++counts[contact.kind];
  std::string text;
  for (const auto& row : molecular_contact_kinds())
    if (wanted.has(row.kind) || counts[row.kind] > 0)
      text += (text.empty() ? "" : ", ") + std::string(row.name) + " " +
              std::to_string(counts[row.kind]);
  return "contacts: " + text;
}

/// Builds a model of a structure that was made ready.
class ModelBuilder {
 public:
  ModelBuilder(const ModelOptions& options, Preparation ready)
      : options_(options), entry_(entry(options.kind)), ready_(std::move(ready)) {}

  MolecularModel build() {
    building_.bars = entry_.bars;
    building_.pin = options_.pin;
    building_.may_be_cut = true;  // which build_model has asked
    if (entry_.has_contacts) take_contacts();
    if (entry_.has_sterics && options_.sterics) take_sterics();
    if (entry_.has_sterics && options_.torsions) take_torsions();
    Framework framework = build_framework(ready_.structure, building_);
    std::vector<Vec3> positions = ready_.structure.positions;
    const auto placed = static_cast<std::size_t>(std::ranges::count(ready_.origin, no_atom));
    return {options_.kind,
            std::move(ready_.structure),
            std::move(framework),
            std::move(positions),
            std::move(contacts_),
            std::move(ready_.steps),
            std::move(ready_.missing),
            std::move(ready_.left_out),
            placed};
  }

 private:
  void note(std::string line) {
    options_.log.detail(line);
    ready_.steps.push_back(std::move(line));
  }

  void take_contacts() {
    contacts_ = contacts_for(ready_, options_);
    check_atoms();
    building_.limits =
        without_barred(limits_of(contacts_), build_framework(ready_.structure, building_));
    note(note_of_contacts(contacts_, WantedKinds(options_.more_contacts)));
  }

  /// Contacts that a caller gives may name anything.
  void check_atoms() const {
    const std::size_t count = ready_.structure.size();
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const MolecularContact& c = contacts_[k];
      for (std::uint32_t atom : {c.a, c.b, c.hydrogen, c.base}) {
        const bool may_lack = atom == MolecularContact::none && atom != c.a && atom != c.b;
        if (atom >= count && !may_lack)
          throw InputError("contact " + std::to_string(k) + " names atom " + std::to_string(atom) +
                           " of " + std::to_string(count) + " (counted from 0)");
      }
      if ((c.hydrogen == MolecularContact::none) != (c.base == MolecularContact::none))
        throw InputError("contact " + std::to_string(k) +
                         ": expected both a hydrogen and a base, or neither");
    }
  }

  /// Pairs that are too close at the start keep the distance that they have.
  void take_sterics() {
    Sterics sterics = molecular_sterics(ready_.structure, options_.prepare.all_hydrogens);
    const Framework joints({.joint_count = ready_.structure.size(),
                            .sterics = std::make_shared<const Sterics>(sterics)});
    sterics.own = own_distances(joints, ready_.structure.positions);
    if (!sterics.own.empty())
      note("sterics: " + std::to_string(sterics.own.size()) +
           " atom pairs are already closer than usual in the file; these distances are allowed");
    building_.sterics = std::make_shared<const Sterics>(std::move(sterics));
  }

  void take_torsions() {
    TorsionPreferences torsions = torsions_of_residues(ready_.structure);
    if (torsions.staggered.empty() && torsions.backbone.empty()) return;
    note("torsions: " + std::to_string(torsions.staggered.size()) +
         " of side chains prefer to be staggered, phi and psi of " +
         std::to_string(torsions.backbone.size()) + " residues prefer the usual regions");
    building_.torsion_preferences = std::make_shared<const TorsionPreferences>(std::move(torsions));
  }

  const ModelOptions& options_;
  const ModelEntry& entry_;
  Preparation ready_;
  BuildOptions building_;
  std::vector<MolecularContact> contacts_;
};

}  // namespace

std::span<const ModelEntry> models() { return table; }

const ModelEntry& entry(ModelKind kind) { return table[static_cast<std::size_t>(kind)]; }

ModelKind usual_model(const Structure& structure) {
  const auto& residues = structure.atoms.residues;
  const std::vector<bool> is_polymer = polymer_residues(structure);
  for (std::size_t r = 0; r < residues.size(); ++r)
    if (is_polymer[r] && (is_amino_acid(residues[r]) || is_nucleotide(residues[r])))
      return ModelKind::protein;
  return ModelKind::molecule;
}

std::vector<MolecularContact> find_contacts(const Structure& structure, const ModelOptions& options,
                                            const std::vector<bool>& floppy) {
  const WantedKinds wanted(options.more_contacts);
  const ContactOptions finding{options.hydrogen_bonds, options.tethers};
  std::vector<MolecularContact> all;
  for (ContactFinder* find : wanted.finders()) {
    const std::vector<MolecularContact> found = find(structure, finding);
    all.insert(all.end(), found.begin(), found.end());
  }
  const auto& residue_of = structure.atoms.residue_of;
  const auto is_floppy = [&](std::uint32_t atom) {
    return !floppy.empty() && floppy[residue_of[atom]];
  };
  std::erase_if(all, [&](const MolecularContact& contact) {
    return !wanted.has(contact.kind) || is_floppy(contact.a) || is_floppy(contact.b);
  });
  return all;
}

std::vector<MolecularContact> contacts_for(const Preparation& ready, const ModelOptions& options) {
  const bool are_given = options.contacts || !options.contacts_file.empty();
  if (are_given && !options.more_contacts.empty())
    throw OptionError("more_contacts: goes with contacts that are found, not with given ones");
  if (options.contacts) return *options.contacts;
  if (!options.contacts_file.empty())
    return read_contacts(path_of(options.contacts_file), ready.structure);
  return find_contacts(ready.structure, options, ready.floppy);
}

NamedParameter left_out_of(const MolecularModel& model) {
  std::string text;
  for (const std::string& one : model.left_out) text += (text.empty() ? "" : "; ") + one;
  return {"model/left_out", text};
}

MolecularModel build_model(const Structure& structure, const ModelOptions& options) {
  if (!options.may_be_cut) refuse_cut(structure);
  PrepareOptions preparing = options.prepare;
  if (!preparing.log.function) preparing.log = options.log;
  Preparation ready;
  if (entry(options.kind).is_prepared) {
    ready = prepare(structure, preparing);
  } else {
    ready.structure = structure;
  }
  return ModelBuilder(options, std::move(ready)).build();
}

}  // namespace pliant
