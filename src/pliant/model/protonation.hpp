// SPDX-License-Identifier: MIT
// Protonation: which form of a titratable residue there is. By the residue's name (HID, ASH), by
// what is asked for, by its hydrogens, else by a table for pH 7.
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
  std::string_view summary;  ///< "hydrogen on ND1"
};

/// The forms that can be asked for.
std::span<const ProtonationForm> protonation_forms();

/// (R) the form of each residue: its own name, or that of a row of protonation_forms().
///
/// `wanted` are "HIS57:HID" or, where several chains have that residue, "A:HIS57:HID". Otherwise:
/// names that say a form (HID, HSE, GLUP, CYX) hold; Asp and Glu carry no hydrogen, Lys and Arg are
/// charged; Cys on sulphur or a metal has none; His carries its hydrogen on NE2, but on ND1 where
/// NE2 holds a metal or only ND1 has an acceptor within 3.3 Angstrom.
/// Throws OptionError naming what is wrong with a `wanted`.
std::vector<std::string> protonation_of(const Structure& structure,
                                        const std::vector<std::string>& wanted);

}  // namespace pliant
