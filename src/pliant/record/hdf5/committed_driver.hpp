// SPDX-License-Identifier: MIT
// HDF5 file driver (virtual file layer) on top of CommittedFile.
#pragma once

#include "pliant/record/hdf5/committed_file.hpp"
#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {

/// Creates an HDF5 file in `file`, which must not move until the returned identifier and all
/// identifiers opened from it are closed. Format of HDF5 1.0 to 1.8, no time stamps, no HDF5 lock,
/// so that any HDF5 program opens it, also while it is being written. Throws FileError.
Hid create_hdf5(CommittedFile& file);

/// Opens the HDF5 file in `file` for writing; otherwise as create_hdf5.
Hid open_hdf5_to_write(CommittedFile& file);

}  // namespace pliant
