// SPDX-License-Identifier: MIT
// PDB recorder (trajectory writer): frames as the models of one PDB file, for viewers. H5MD holds
// more, in full precision, and survives the death of its writer.
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

/// Writes each frame as a MODEL to a file beside its final name, which it takes when it is closed
/// with at least one model: half a model is never seen under that name. Positions in Angstrom to
/// 0.001; steps, times and observables are left out, as the format has no place for them; neither
/// has it one for atoms past 10^8. CONECT records follow the last model.
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

  /// Ends the file and gives it its name; without a model there is none. Closing again does
  /// nothing. Throws FileError. What is not closed is deleted.
  void close();

  std::int64_t models() const;
  const std::filesystem::path& path() const;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace pliant
