// SPDX-License-Identifier: MIT
// Where the repository lies. The one source that knows it is compiled anew in each clone, all
// others come from the compiler's cache.
#pragma once

#include <filesystem>
#include <string>

namespace pliant {

std::filesystem::path source_folder();

/// data/molecules
std::filesystem::path molecules_folder();

/// The path of one of the molecules: "caffeine.sdf".
std::string molecule_file(const std::string& name);

}  // namespace pliant
