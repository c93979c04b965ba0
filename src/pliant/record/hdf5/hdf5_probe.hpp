// SPDX-License-Identifier: MIT
// Reads an HDF5 file in a process of its own first, which may crash in our place.
#pragma once

#include <filesystem>

namespace pliant {

/// Forks a process that opens all objects, reads their attributes and looks up where their values
/// are. Throws InputError if HDF5 crashes there, or does not end in some seconds of the processor's
/// time; what HDF5 merely refuses, it refuses again for the caller. Callers hold an Hdf5Session.
void probe_hdf5(const std::filesystem::path& path);

}  // namespace pliant
