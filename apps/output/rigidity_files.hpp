// SPDX-License-Identifier: MIT
// The folder that pliant rigidity writes: tables, molecules with B factors, and viewer scripts.
#pragma once

#include <string>
#include <vector>

#include "output/rigidity_report.hpp"
#include "pliant/base/log.hpp"

namespace pliant::app {

/// Names of the files.
std::vector<std::string> rigidity_file_names(bool has_dilution);

/// Writes all files, each atomically. Throws FileError with the system's reason, or if one exists
/// and `overwrite` is false.
void write_rigidity_folder(const std::string& folder, const RigidityReport& report, bool overwrite,
                           const Log& log);

}  // namespace pliant::app
