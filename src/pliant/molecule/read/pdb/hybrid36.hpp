// SPDX-License-Identifier: MIT
// Numbers that outgrew their PDB columns: hybrid-36 (cci.lbl.gov/hybrid_36: decimal, then A0000 ...
// ZZZZZ, then a0000 ... zzzzz) and the hexadecimal of VMD and Packmol (186a0 after 99999).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace pliant {

/// A decimal or hybrid-36 number that fills `field` but for leading and trailing blanks; letters
/// count only where all columns of the field are used. "A0000" is 100000, "A000" 10000.
std::optional<std::int64_t> parse_hybrid36(std::string_view field);

/// A number that begins with a digit and holds a letter from a to f, as no hybrid-36 number does.
std::optional<std::int64_t> parse_vmd_hexadecimal(std::string_view field);

/// The hexadecimal number that fills `field`, also where it has no letter.
std::optional<std::int64_t> parse_hexadecimal(std::string_view field);

}  // namespace pliant
