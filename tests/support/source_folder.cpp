// SPDX-License-Identifier: MIT
#include "support/source_folder.hpp"

namespace pliant {

std::filesystem::path source_folder() { return PLIANT_SOURCE_DIR; }

std::filesystem::path molecules_folder() { return source_folder() / "data" / "molecules"; }

std::string molecule_file(const std::string& name) { return molecules_folder() / name; }

}  // namespace pliant
