// SPDX-License-Identifier: MIT
// SDF recorder: frames as records of one SDF file, the usual form of conformers for docking and
// cheminformatics programs. V2000 up to 999 atoms and bonds and where positions fit its columns,
// else V3000 (Biovia, CTfile formats, 2020).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/atom_table.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/record/topology_pdb.hpp"

namespace pliant {

/// Properties of a molecule besides elements and bonds. Each column has N numbers or none.
struct SdfMolecule {
  std::string title = "";               ///< first line of each record
  std::vector<std::int8_t> charges;     ///< formal
  std::vector<std::uint16_t> isotopes;  ///< mass numbers; 0: the natural mixture
  std::vector<std::uint8_t> radicals;   ///< 1 singlet, 2 doublet, 3 triplet; 0: none
};

/// Writes each frame as a record, with its number as the data item "frame", to a temporary file,
/// which gets its final name when it is closed with at least one record. Positions are in Angstrom
/// to 0.0001. Bonds of unknown order are written as single bonds.
class SdfRecorder {
 public:
  struct Options {
    bool overwrite = false;
  };

  /// Throws FileError as H5mdRecorder does, InputError without atoms.
  SdfRecorder(const std::filesystem::path& path, std::shared_ptr<const AtomTable> atoms,
              std::vector<RecordedBond> bonds, SdfMolecule molecule, const Options& options);
  ~SdfRecorder();
  SdfRecorder(SdfRecorder&&) noexcept;
  SdfRecorder& operator=(SdfRecorder&&) noexcept;

  /// Throws InputError where the number of positions is not that of the atoms, or one is beyond
  /// 1e9 Angstrom; FileError where it cannot be written.
  void record(const Frame& frame);

  /// Renames the file, or deletes it if it has no record. A recorder that is not closed deletes its
  /// file.
  void close();

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace pliant
