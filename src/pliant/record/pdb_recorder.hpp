// SPDX-License-Identifier: MIT
// PDB recorder (trajectory writer): frames as models of one PDB file, for viewers. H5MD holds more,
// in full precision, and survives the death of the writer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/atom_table.hpp"
#include "pliant/framework/frame.hpp"
#include "pliant/record/topology_pdb.hpp"

namespace pliant {

/// Writes each frame as a MODEL to a temporary file, which gets its final name when it is closed
/// with at least one model, so that the named file is always complete. Positions are in Angstrom to
/// 0.001. The format has no place for steps, times and observables, nor for atoms past 10^8. CONECT
/// records follow the last model.
class PdbRecorder {
 public:
  /// Throws FileError as H5mdRecorder does.
  PdbRecorder(const std::filesystem::path& path, std::shared_ptr<const AtomTable> atoms,
              std::vector<RecordedBond> bonds = {}, const TopologyPdbOptions& options = {});
  ~PdbRecorder();
  PdbRecorder(PdbRecorder&&) noexcept;
  PdbRecorder& operator=(PdbRecorder&&) noexcept;

  /// Throws InputError where the number of positions is not that of the atoms, or one does not fit
  /// the columns (-999.999 to 9999.999 Angstrom); FileError where it cannot be written, or the
  /// recorder is closed.
  void record(std::span<const Vec3> positions);
  void record(const Frame& frame) { record(frame.positions); }

  /// Ends the file and renames it, or deletes it if it has no model. Closing again does nothing.
  /// Throws FileError. A recorder that is not closed deletes its file.
  void close();

  std::int64_t models() const;
  const std::filesystem::path& path() const;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace pliant
