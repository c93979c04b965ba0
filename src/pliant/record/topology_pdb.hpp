// SPDX-License-Identifier: MIT
// Topology sidecar: a PDB file (wwPDB format 3.3) of one frame with CONECT records, for programs
// that read positions from H5MD but names and bonds from elsewhere.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "pliant/base/log.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

struct TopologyPdbOptions {
  bool overwrite = false;  ///< replace an existing file once the new one is written
  /// Write CONECT records of atoms past 99,999 with hybrid-36 serials, too. MDAnalysis (2.11)
  /// cannot open such a file.
  bool hybrid36_bonds = false;
  std::string title = "";  ///< TITLE record; "": none
  Log log = {};  ///< receives one message for each kind of data that does not fit a PDB file
};

/// Writes atoms, positions (N; Angstrom) and bonds. Serials are 1 to N in the order of the joints,
/// hybrid-36 past 99,999, as are residue numbers past 9999. A bond of order 2 or 3 is listed two or
/// three times. Names that are too long are cut, with a warning; a chain of several letters becomes
/// the segment, and its first letter the chain. The file appears only when it is complete. Throws
/// InputError naming the atom where a coordinate, rounded to 0.001, is not within -999.999 to
/// 9999.999, a residue number not within -999 to 2,436,111, or a bond leads to no atom; FileError
/// with the system's reason.
void write_topology_pdb(const std::filesystem::path& path, const AtomTable& atoms,
                        std::span<const Vec3> positions, std::span<const RecordedBond> bonds,
                        const TopologyPdbOptions& options = {});

/// Throws InputError as write_topology_pdb does if an atom or its position (N; Angstrom) does not
/// fit.
void check_topology_pdb(const AtomTable& atoms, std::span<const Vec3> positions);

/// `number` in `width` columns: decimal, then hybrid-36 (cci.lbl.gov/hybrid_36). Throws InputError
/// when it does not fit.
std::string hybrid36(std::int64_t number, std::size_t width);

}  // namespace pliant
