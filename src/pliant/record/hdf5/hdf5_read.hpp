// SPDX-License-Identifier: MIT
// Reading untrusted HDF5 files: nothing outside the file is opened, no memory is taken for data
// that the file does not hold, and errors name the path. Identifiers are HDF5's hid_t.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/record/hdf5/hdf5_session.hpp"

namespace pliant {

/// Opens a file for reading after checking its structure, because HDF5 can crash on a wrong byte.
/// Throws FileError with a reason that says what to do, and InputError where the file is damaged;
/// neither names the file.
Hid open_hdf5(const std::filesystem::path& path);

/// Whether `path` leads to an object within the file. Throws FileError on a link that leaves the
/// file.
bool has_object(std::int64_t location, const std::string& path);
/// Opens a group or dataset. Throws as has_object, and when there is none.
Hid open_object(std::int64_t location, const std::string& path);
/// Names in the group, sorted; empty if there is no such group.
std::vector<std::string> names_in(std::int64_t location, const std::string& group);
/// Paths of all datasets below `group`, relative to it, sorted; soft links are not followed, and
/// what lies below 50 levels is left out.
std::vector<std::string> datasets_below(std::int64_t location, const std::string& group);

/// The text of an attribute of fixed or variable length; nothing if there is none.
std::optional<std::string> text_attribute(std::int64_t object, const char* name);
std::optional<double> number_attribute(std::int64_t object, const char* name);

}  // namespace pliant
