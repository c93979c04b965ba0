// SPDX-License-Identifier: MIT
// The task `rigidity`: from a molecule with its contacts, and what is asked for, to what of it is
// rigid. The command and Python come in through this door.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/base/option_fields.hpp"
#include "pliant/model/rigidity/dilution_picture.hpp"
#include "pliant/model/rigidity/rigidity.hpp"

namespace pliant {

/// How freedoms are counted, as users say it: see RigidityOptions.
struct RigidityAsked {
  std::int64_t hbond_bars = entry(MolecularContactKind::hydrogen_bond).bars;
  std::int64_t tether_bars = entry(MolecularContactKind::hydrophobic).bars;
  bool ends_turn = true;
  std::string free_angles = {};  ///< selection of atoms; "": none
};

/// The command's options, Python's keywords and ranges come from this table.
std::span<const OptionField<RigidityAsked>> rigidity_fields();

/// What was found, and of what.
struct MoleculeRigidity {
  ContactModel model;
  Rigidity rigidity;
};

/// Throws OptionError for an option out of its range and a selection that names no atom, and as
/// analyse_rigidity() does.
MoleculeRigidity find_rigidity(ContactModel model, const RigidityAsked& asked);

/// Dilutes what was found (dilute_hydrogen_bonds) and draws it. `name` is what the title calls the
/// molecule; "": its file.
DrawnDilution draw_dilution(const MoleculeRigidity& found, const std::string& name = {});

}  // namespace pliant
