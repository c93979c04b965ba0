// SPDX-License-Identifier: MIT
// The files of the thesis laboratory, read or refused, as lines of text that corpus tests compare.
#pragma once

#include <span>
#include <string>

#include "pliant/text/file_text.hpp"

namespace pliant {

/// One kind of file: its folder in the corpus, and what reading one gives: warnings in their order,
/// then the error, or all that it holds, one line each.
struct LaboratoryFile {
  const char* folder;
  std::string (*read)(const SourceText& source);
};

/// graph, and those that are read for joints a, b, c, d and bars ab, bc, ca, cd: ordering, forces,
/// bars; and results.
std::span<const LaboratoryFile> laboratory_files();

}  // namespace pliant
