// SPDX-License-Identifier: MIT
// Looks at the whole structure of an HDF5 file before HDF5 does, which a wrong byte can crash.
#pragma once

#include <filesystem>

namespace pliant {

/// Walks through everything that the file's root leads to, within bounds and once: superblock,
/// object headers, datatypes, attributes, groups, heaps, and trees of chunks, but not the values.
/// Takes time and memory for the metadata only.
///
/// Returns whether all of it was understood: files of HDF5 1.0 to 1.8 as we write them. Parts of
/// newer formats (groups with many links, other indices of chunks), which have checksums of their
/// own, and shared types are left out.
/// Throws InputError "is damaged: ...", or "is not an HDF5 file"; FileError where it cannot be
/// read.
bool check_hdf5_structure(const std::filesystem::path& path);

}  // namespace pliant
