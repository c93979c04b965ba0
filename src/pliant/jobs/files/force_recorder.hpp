// SPDX-License-Identifier: MIT
// Records the pushes of a run as a force file, so that they can be replayed.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/run/run_options.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

/// The force file that the pushes of a run become, without them. `is_counted`: of a run in hands,
/// whose other pushes are made again and not listed.
ForceFile force_file_of(const RunOptions& options, ForceHeader header, bool is_counted = false);

/// The force file that the pushes of a run become: complete once the run has ended, or not
/// at all. It keeps the forces of a push that acted by move_by_verlet; the root joint and 0 if
/// there were none. For a run in hands (`held_back`) it keeps what they asked for, and counts steps
/// in which nothing changed: the settings say what drives the run besides, and take no memory
/// however long it goes on.
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
