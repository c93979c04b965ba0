// SPDX-License-Identifier: MIT
// Numbers that overflow their PDB columns: hybrid-36 (cci.lbl.gov/hybrid_36: decimal, then A0000
// ... ZZZZZ, then a0000 ... zzzzz) and the hexadecimal of VMD and Packmol (186a0 after 99999).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace pliant {

/// A decimal or hybrid-36 number that fills `field` except for leading and trailing blanks. Letters
/// are accepted only where all columns are used. "A0000" is 100000, "A000" 10000.
std::optional<std::int64_t> parse_hybrid36(std::string_view field);

/// A hexadecimal number that begins with a digit and has a letter a to f, which no hybrid-36 number
/// does.
std::optional<std::int64_t> parse_vmd_hexadecimal(std::string_view field);

/// The hexadecimal number that fills `field`, even without a letter.
std::optional<std::int64_t> parse_hexadecimal(std::string_view field);

}  // namespace pliant
