// SPDX-License-Identifier: MIT
// Records the pushes of a run as a force file, so that they can be replayed.
#pragma once

#include <filesystem>

#include "pliant/perturb/force_file.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {

/// The force file that the pushes of a run become: there as a whole once the run has ended, or not
/// at all. Of a push the forces are kept that acted by move_by_verlet; if it had none, the root
/// joint and 0.
class ForceRecorder {
 public:
  /// `settings` without pushes; the framework must outlive it. `only_counts_random`: a push of one
  /// force is the perturbation's, which the settings describe; such steps are counted, and take no
  /// memory however many there are. Throws FileError as OutputFile does.
  ForceRecorder(const std::filesystem::path& path, bool overwrite, const Framework& framework,
                ForceFile settings, bool only_counts_random = false);

  void record(const Push& push);
  /// Gives the file its name. Throws as OutputFile and write_force_file do.
  void publish();

 private:
  const Framework& framework_;
  ForceFile forces_;
  OutputFile file_;
  bool only_counts_random_;
};

}  // namespace pliant
