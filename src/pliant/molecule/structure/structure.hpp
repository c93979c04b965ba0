// SPDX-License-Identifier: MIT
// Structure: the chemistry in a file. Atoms with names, elements and positions, and the bonds that
// the file states.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"
#include "pliant/molecule/structure/cell.hpp"

namespace pliant {

/// How a bond is known, best first.
enum class BondOrigin : std::uint8_t {
  file,      ///< the file states it (CONECT, SSBOND, LINK, struct_conn, SDF bond block)
  residue,   ///< template of a standard residue
  link,      ///< between consecutive residues of a chain (peptide C-N, O3'-P), or a disulphide
  distance,  ///< guessed from the distance of two atoms
};
inline constexpr std::array<std::string_view, 4> bond_origin_names{"file", "residue", "link",
                                                                   "distance"};

/// A bond between two atoms, a < b.
struct Bond {
  std::uint32_t a = 0, b = 0;
  BondOrigin origin = BondOrigin::file;
  std::uint8_t order = 0;  ///< 1, 2, 3; 4 aromatic; 0 not known

  friend bool operator==(const Bond&, const Bond&) = default;
};

/// What the B factors of a file are, as far as it says.
enum class BFactorSource : std::uint8_t {
  unknown,
  experiment,  ///< B factors, of a crystal, a map or NMR
  model,       ///< of a theoretical model: no B factors
  confidence,  ///< pLDDT or the like
};

/// One molecule (or crystal, or simulation system) of N atoms at one set of positions.
struct Structure {
  std::string title;   ///< the file's own, may be empty
  std::string source;  ///< name of the file it was read from
  std::string format;  ///< "pdb", "mmcif", "xyz", "sdf"
  AtomTable atoms;
  std::vector<Vec3> positions;          ///< (N) Angstrom
  std::vector<Bond> bonds;              ///< sorted by (a, b), each pair once
  std::vector<std::int8_t> charges;     ///< (N) formal charges in the file; empty: none
  std::vector<std::uint16_t> isotopes;  ///< (N) mass numbers in the file, or 0; empty: none
  std::vector<std::uint8_t> radicals;   ///< (N) 1 singlet, 2 doublet, 3 triplet, 0 none; or empty
  std::vector<float> b_factors;  ///< (N) Angstrom^2, or a confidence; empty: the format has none
  BFactorSource b_factor_source = BFactorSource::unknown;
  std::string b_factor_record;  ///< what says so: "EXPDTA X-RAY DIFFRACTION"; may be empty
  std::vector<bool> chain_end;  ///< (R) the chain ends after this residue (TER); empty: not known
  std::size_t model = 1;        ///< which model or frame this is, from 1
  std::size_t model_count = 1;  ///< models or frames in the file
  std::vector<std::string> assemblies;  ///< names of the biological assemblies in the file
  std::optional<Cell> cell;             ///< periodic cell, if known
  std::uint8_t dimensions = 0;          ///< 2 or 3 if the file says so (SDF), else 0
  /// (N) where each atom stands in the file or list that they are from, counted among the atoms
  /// that are here; empty: in this order
  std::vector<std::uint32_t> source_order;

  std::size_t size() const { return positions.size(); }
};

}  // namespace pliant
