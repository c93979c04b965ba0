// SPDX-License-Identifier: MIT
// Reads an HDF5 file in a separate process first, which may crash.
#pragma once

#include <filesystem>

namespace pliant {

/// Forks a process that opens all objects, reads their attributes and looks up where their values
/// are. Throws InputError if HDF5 crashes there or takes more than some seconds of CPU time. Errors
/// that HDF5 reports itself are left to the caller, who meets them again. On Windows, which has no
/// fork, nothing is tried first. Callers hold an Hdf5Session.
void probe_hdf5(const std::filesystem::path& path);

}  // namespace pliant
