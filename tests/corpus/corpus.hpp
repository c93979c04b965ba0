// SPDX-License-Identifier: MIT
// The corpus of good and bad input files, and what reading each must give.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// One reading: a section of an expected.txt.
struct CorpusCase {
  std::string folder;     ///< "pdb"
  std::string file;       ///< "pdb28_two_models.pdb"
  std::size_t model = 1;  ///< from "== pdb28_two_models.pdb model 2"
  std::string expected;   ///< lines as reading_as_text gives them
};

inline const char* const corpus_folders[] = {"pdb", "xyz", "sdf", "mmcif"};

std::filesystem::path corpus_folder(const std::string& name);

/// All sections of tests/corpus/FOLDER/expected.txt. There, "== FILE [model N]" begins a section
/// and "# ..." says why the reading is right.
std::vector<CorpusCase> corpus_cases(const std::string& folder);

}  // namespace pliant
