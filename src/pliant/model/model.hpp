// SPDX-License-Identifier: MIT
// The model of a molecule: the constraints that hold it. A table of models, from bonds alone to
// those of a protein: bars, sterics and contacts.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/parameter.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/model/contacts/contact_options.hpp"
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
  bool is_prepared = false;  ///< waters out, polar hydrogens in
  bool has_sterics = false;
  bool has_contacts = false;  ///< those of molecular_contact_kinds()
};

/// All models, in the order of their numbers.
std::span<const ModelEntry> models();

/// The row of a kind.
const ModelEntry& entry(ModelKind kind);

/// The default model of a structure: protein if it has amino acids or nucleotides that are parts of
/// a polymer (polymer_residues), else molecule: an amino acid alone is a small molecule.
ModelKind usual_model(const Structure& structure);

struct ModelOptions {
  ModelKind kind = ModelKind::protein;
  PrepareOptions prepare = {};
  HydrogenBondOptions hydrogen_bonds = {};
  TetherOptions tethers = {};
  std::vector<std::string> more_contacts = {};  ///< kinds that are found besides the usual ones
  bool sterics = true;                          ///< allow sterics; not all models have them
  bool torsions = true;  ///< torsion preferences with the sterics; sample() heeds them
  /// Contacts that replace those to be found; atoms of the prepared structure.
  std::optional<std::vector<MolecularContact>> contacts = std::nullopt;
  std::string contacts_file = "";  ///< a file of such contacts (read_contacts); "": none
  std::string pin = "";            ///< selection of atoms that never move; "": none
  bool may_be_cut = false;         ///< accept a molecule that a periodic box has cut
  Log log = {};
};

/// A prepared structure and its framework.
struct MolecularModel {
  ModelKind kind = ModelKind::protein;
  Structure structure;
  Framework framework;          ///< bars, limits (group k is contact k), sterics
  std::vector<Vec3> positions;  ///< (N) Angstrom, start; satisfies all limits and least distances
  std::vector<MolecularContact> contacts;
  std::vector<std::string> notes;     ///< what was done and found, one sentence each
  std::vector<std::string> missing;   ///< what the structure lacks
  std::vector<std::string> left_out;  ///< what of the file is not in it: see Preparation
  std::size_t placed = 0;             ///< atoms placed by rule
};

/// What a model has left out, as files keep it: "model/left_out".
NamedParameter left_out_of(const MolecularModel& model);

/// Builds the model of a structure whose bonds are known (perceive_bonds), after prepare() for
/// models that need it. Pairs of atoms that are nearer than the table of sterics allows keep their
/// own distance; limits of pairs with a bar are left out. Linear in the number of atoms. Throws as
/// refuse_cut(), prepare(), read_contacts() and build_framework() do.
MolecularModel build_model(const Structure& structure, const ModelOptions& options = {});

/// Finds the contacts of a prepared structure: of the usual kinds and of those that the options
/// name, without those of floppy residues. `floppy` (R) may be empty. Throws OptionError for an
/// unknown kind.
std::vector<MolecularContact> find_contacts(const Structure& structure, const ModelOptions& options,
                                            const std::vector<bool>& floppy = {});

/// The contacts that the options give, be it as a list or as a file; else those that are found.
/// Throws as find_contacts() and read_contacts() do; OptionError where they are given and kinds to
/// be found are named, too.
std::vector<MolecularContact> contacts_for(const Preparation& ready, const ModelOptions& options);

}  // namespace pliant
