// SPDX-License-Identifier: MIT
// Protonation: which form of a titratable residue there is. By what is asked for, by the residue's
// name (HID, ASH), by its hydrogens, else by a table for pH 7.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A form of a residue: one row of the table of forms.
struct ProtonationForm {
  std::string_view name;     ///< "HID"
  std::string_view residue;  ///< "HIS"
  std::string_view aliases;  ///< names of force fields that say this form
  std::string_view summary;  ///< "hydrogen on ND1"
};

/// The forms that can be asked for.
std::span<const ProtonationForm> protonation_forms();

/// The form of each residue.
struct Protonation {
  std::vector<std::string> forms;  ///< (R) a name of the table, else the residue's standard name
  std::vector<bool> is_asked_for;  ///< (R) whether `wanted` says it, whatever hydrogens there are
};

/// The forms of a structure whose bonds are known.
///
/// `wanted` are "HIS57:HID" or, where several chains have that residue, "A:HIS57:HID". Otherwise:
/// names that say a form (HID, HSE, GLUP, CYX) hold; Asp and Glu carry no hydrogen, Lys and Arg are
/// charged; Cys bonded to more than its carbon or near a metal has none; His carries its hydrogen
/// on NE2, but on ND1 where NE2 is at a metal, or where only ND1 has an O within 3.3 Angstrom; on
/// neither where both are at metals (HIN).
/// Throws OptionError naming what is wrong with a `wanted`.
Protonation protonation_of(const Structure& structure, const std::vector<std::string>& wanted);

}  // namespace pliant
