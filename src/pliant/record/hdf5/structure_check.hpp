// SPDX-License-Identifier: MIT
// Checks the whole structure of an HDF5 file first, because HDF5 can crash on a wrong byte.
#pragma once

#include <filesystem>

namespace pliant {

/// Walks once, within bounds, through everything that the file's root leads to: superblock, object
/// headers, datatypes, attributes, groups, heaps, and trees of chunks, but not the values. Time and
/// memory are proportional to the metadata.
///
/// Returns whether all of it could be checked, as in files of HDF5 1.0 to 1.8 written by Pliant.
/// Shared types and parts of newer formats, which have checksums (groups with many links, other
/// indices of chunks), are skipped. Throws InputError "is damaged: ...", or "is not an HDF5 file";
/// FileError where it cannot be read.
bool check_hdf5_structure(const std::filesystem::path& path);

}  // namespace pliant
