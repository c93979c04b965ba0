// SPDX-License-Identifier: MIT
// Protonation: the form of each titratable residue, as asked for, by the residue's name (HID, ASH),
// by its hydrogens, or else by a table for pH 7.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A form of a residue: one row of the table of forms.
struct ProtonationForm {
  std::string_view name;     ///< "HID"
  std::string_view residue;  ///< "HIS"
  std::string_view aliases;  ///< names of this form in force fields
  std::string_view summary;  ///< "hydrogen on ND1"
};

/// The forms that users can ask for.
std::span<const ProtonationForm> protonation_forms();

/// The form of each residue.
struct Protonation {
  std::vector<std::string> forms;  ///< (R) a name of the table, or the residue's standard name
  std::vector<bool> is_asked_for;  ///< (R) whether `wanted` names the form, whatever the hydrogens
};

/// The forms of a structure whose bonds are known.
///
/// `wanted` are "HIS57:HID" or, if several chains have that residue, "A:HIS57:HID". For other
/// residues: names of a form (HID, HSE, GLUP, CYX) decide; Asp and Glu have no hydrogen, Lys and
/// Arg are charged; Cys has none if bonded to more than its carbon or near a metal; His has its
/// hydrogen on NE2, but on ND1 if NE2 is at a metal or only ND1 has an O within 3.3 Angstrom, and
/// on neither if both are at metals (HIN). Throws OptionError naming what is wrong with a `wanted`.
Protonation protonation_of(const Structure& structure, const std::vector<std::string>& wanted);

/// Whether an N is bonded to a C of another residue as in amides and imines, or to P, S or B: then
/// it is no amine.
bool is_acylated(const Structure& structure, const AtomGraph& graph, std::uint32_t n);

}  // namespace pliant
