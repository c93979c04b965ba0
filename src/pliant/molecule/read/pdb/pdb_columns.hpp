// SPDX-License-Identifier: MIT
// Fixed columns of PDB records (wwPDB format 3.3), read strictly.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"
#include "pliant/molecule/read/shared/fixed_columns.hpp"
#include "pliant/molecule/read/shared/remarks.hpp"

namespace pliant {

/// A line and its number.
struct PdbLine {
  std::string_view text;
  std::size_t number;
};

/// x, y, z of an ATOM or HETATM record. Throws InputError where a field is blank, truncated or not
/// a number, the columns contain a tab, or a long serial number has shifted them.
Vec3 pdb_position(const PdbLine& line, const Remarks& remarks);

/// Names of a residue and its chain.
struct PdbNames {
  std::string_view residue, chain;
};

/// The residue name that begins in column `first` and the chain in column `first` + 4. The column
/// between belongs to the residue name ("TIP3", "NALA"), unless the three columns before it name a
/// standard residue: then it is the first letter of a two-letter chain.
PdbNames pdb_names(std::string_view line, std::size_t first);

/// Residue of an ATOM or HETATM record. A digit in the insertion-code column after a full number is
/// its fifth digit (with a warning). `previous` gives the number where the field has overflowed to
/// "****".
Residue pdb_residue(const PdbLine& line, const Residue& previous, Remarks& remarks);

/// Segment (columns 73-76, segid) where that is one: letters and digits, as neither charges nor
/// numbers that run into these columns are. "" for none.
std::string_view pdb_segment(std::string_view line);

/// Occupancy (columns 55-60); 1 where it is blank; 1 with a warning where it is not a number. Also
/// warns of an invalid B factor (columns 61-66): renamed PQR files have both.
float pdb_occupancy(const PdbLine& line, Remarks& remarks);

/// B factor (columns 61-66); 0 where it is blank or invalid, of which pdb_occupancy warns.
float pdb_b_factor(const PdbLine& line);

/// Formal charge (columns 79-80: "2+", "+2", "1-"); 0 where blank; 0 with a warning otherwise.
std::int8_t pdb_charge(const PdbLine& line, Remarks& remarks);

/// Whether the residue number has overflowed to "****".
bool has_starred_residue(std::string_view line);

}  // namespace pliant
