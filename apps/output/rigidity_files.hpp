// SPDX-License-Identifier: MIT
// The folder that pliant rigidity writes: tables, molecules with B factors, scripts that show them.
#pragma once

#include <string>
#include <vector>

#include "output/rigidity_report.hpp"
#include "pliant/base/log.hpp"

namespace pliant::app {

/// The names of its files.
std::vector<std::string> rigidity_file_names(bool has_dilution);

/// Writes all of them; each appears as a whole. Throws FileError with the system's reason, or where
/// one is there and `overwrite` is false.
void write_rigidity_folder(const std::string& folder, const RigidityReport& report, bool overwrite,
                           const Log& log);

}  // namespace pliant::app
