// SPDX-License-Identifier: MIT
// Records the pushes of a run as a force file, so that they can be replayed.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

/// Writes the force file of a run's pushes, complete once the run has ended, or not at all. For
/// each push it keeps the forces that acted by move_by_verlet, or, if there were none, the root
/// joint and a force of 0. For a run with hands (`held_back`) it keeps the forces that these asked
/// for, and counts equal steps: the settings describe what else drives the run, so that memory does
/// not grow however long it continues.
class ForceRecorder {
 public:
  /// `settings` without pushes; the framework must outlive it. `held_back` is the longest step of
  /// the hands (Angstrom), see Steering. Throws FileError as OutputFile does.
  ForceRecorder(const std::filesystem::path& path, bool overwrite, const Framework& framework,
                ForceFile settings, std::optional<double> held_back = {});

  void record(const Push& push);
  /// Gives the file its name. Throws as OutputFile and write_force_file do.
  void publish();

 private:
  const Framework& framework_;
  ForceFile forces_;
  OutputFile file_;
  std::optional<double> held_back_;
  std::vector<ForceEvent> events_;  ///< for a run with hands
};

}  // namespace pliant
