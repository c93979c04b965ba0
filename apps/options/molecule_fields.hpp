// SPDX-License-Identifier: MIT
// The options that determine the framework of a file, as force files keep them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "options/molecule_input.hpp"
#include "pliant/perturb/force_files/force_header.hpp"

namespace pliant::app {

using MoleculePlace =
    std::variant<bool*, std::int64_t*, double*, std::string*, std::vector<std::string>*>;

/// One of these options, other than the model and the bars.
struct MoleculeField {
  std::string_view name;  ///< "all_hydrogens", in a line `input` of a force file
  const char* option;     ///< "--all-hydrogens"
  MoleculePlace (*place)(MoleculeOptions& options);
  bool is_file = false;  ///< compared without its folder
};

std::span<const MoleculeField> molecule_fields();

/// The value of an option as set_molecule_field() reads it back.
std::string molecule_field_text(const MoleculeOptions& options, const MoleculeField& field);

/// Throws OptionError naming the option, the text and what was expected.
void set_molecule_field(MoleculeOptions& options, const MoleculeField& field,
                        std::string_view text);

/// The header of a force file for this molecule.
ForceHeader force_header_of(const MoleculeOptions& options, const Molecule& molecule);

}  // namespace pliant::app
