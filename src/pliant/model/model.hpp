// SPDX-License-Identifier: MIT
// The model of a molecule: what holds it. A table of kinds, from bonds alone to all that a protein
// has: bars, sterics, hydrogen bonds, salt bridges and hydrophobic tethers.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/model/contacts/contact_options.hpp"
#include "pliant/model/contacts/hydrogen_bonds.hpp"
#include "pliant/model/contacts/tethers.hpp"
#include "pliant/model/prepare/prepare.hpp"
#include "pliant/molecule/build_framework.hpp"

namespace pliant {

enum class ModelKind : std::uint8_t { bonds, angles, molecule, protein };

/// One row of the table of models.
struct ModelEntry {
  ModelKind kind;
  std::string_view name;     ///< "protein"
  std::string_view summary;  ///< one line for help
  BarKind bars;
  bool is_prepared;  ///< waters out, polar hydrogens in
  bool has_sterics;
  bool has_contacts;  ///< those of molecular_contact_kinds()
};

/// All models, in the order of their numbers.
std::span<const ModelEntry> models();

/// The row of a kind.
const ModelEntry& entry(ModelKind kind);

/// The model that fits a structure: protein where it has amino or nucleic residues, else molecule.
ModelKind usual_model(const Structure& structure);

struct ModelOptions {
  ModelKind kind = ModelKind::protein;
  PrepareOptions prepare = {};
  HydrogenBondOptions hydrogen_bonds = {};
  TetherOptions tethers = {};
  std::vector<std::string> more_contacts = {};  ///< kinds that are found besides the usual ones
  bool sterics = true;                          ///< whether models that have sterics get them
  bool torsions = true;  ///< whether these get torsion preferences, which sample() heeds
  /// Contacts in place of those that would be found; atoms of the prepared structure.
  std::optional<std::vector<MolecularContact>> contacts = std::nullopt;
  std::string contacts_file =
      "";                   ///< the same from a file (read_contacts), after preparation; "": none
  std::string pin = "";     ///< selection of atoms that never move; "": none
  bool may_be_cut = false;  ///< build it even of a molecule that a periodic box has cut
  Log log = {};
};

/// A structure made ready, and the framework that holds it.
struct MolecularModel {
  ModelKind kind = ModelKind::protein;
  Structure structure;
  Framework framework;          ///< bars, limits (group k is contact k), sterics
  std::vector<Vec3> positions;  ///< (N) Angstrom, the start; every limit and least distance holds
  std::vector<MolecularContact> contacts;
  std::vector<std::string> told;     ///< what was done and found, line by line
  std::vector<std::string> missing;  ///< what the file lacks
};

/// The model of a structure whose bonds are known (perceive_bonds). Kinds that are prepared go
/// through prepare(). Pairs of atoms nearer than the table of sterics says keep their own distance;
/// limits of pairs that have a bar are left out. Linear in the number of atoms.
/// Throws as refuse_cut(), prepare(), read_contacts() and build_framework() do.
MolecularModel build_model(const Structure& structure, const ModelOptions& options = {});

/// The contacts of a structure that was made ready: of the usual kinds and of those that the
/// options name; those of floppy residues are left out. `floppy` (R) may be empty. Throws
/// OptionError for a kind that there is not.
std::vector<MolecularContact> find_contacts(const Structure& structure, const ModelOptions& options,
                                            const std::vector<bool>& floppy = {});

/// The contacts that the options give, be it as a list or as a file; else those that are found.
/// Throws as find_contacts() and read_contacts() do; OptionError where they are given and kinds to
/// be found are named, too.
std::vector<MolecularContact> contacts_for(const Preparation& ready, const ModelOptions& options);

}  // namespace pliant
