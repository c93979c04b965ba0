// SPDX-License-Identifier: MIT
// Output of frames of run and sample: an H5MD file, or by its name a PDB or an SDF file.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/record/h5md/saved_part.hpp"
#include "pliant/record/pdb_recorder.hpp"
#include "pliant/record/sdf_recorder.hpp"

namespace pliant {

/// Writes the names and bonds of the recorded joints, at these positions (N, of all joints).
void write_topology(const std::string& path, const Framework& framework, const H5mdHeader& header,
                    std::span<const Vec3> positions, const H5mdOptions& options);

/// Called before anything is made. Returns `path`, or "none" with a warning if a position does not
/// fit the columns of the topology PDB. Throws InputError in that case if the user asked for the
/// file.
std::string fitting_topology(const std::string& path, bool is_asked, const Framework& framework,
                             std::span<const Vec3> positions, const H5mdOptions& options);

/// Records frames in the format of the file's name.
class FrameOutput {
 public:
  /// A PDB file gets only names and bonds; an SDF file gets elements, bonds and `molecule`, with
  /// the file's name as its title if it has none. Throws as the recorders do.
  FrameOutput(const std::string& output, const Framework& framework, const H5mdHeader& header,
              const H5mdOptions& options, SdfMolecule molecule = {});

  void record(const Frame& frame);
  /// Keeps the final state of the run; only H5MD can.
  void end_run(const State& state);
  void close();

 private:
  std::optional<H5mdRecorder> h5md_;
  std::optional<SavedPart> part_;  // for a PDB file
  std::optional<PdbRecorder> pdb_;
  std::optional<SdfRecorder> sdf_;
};

}  // namespace pliant
