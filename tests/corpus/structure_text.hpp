// SPDX-License-Identifier: MIT
// A structure, or why there is none, as lines of text that corpus tests compare.
#pragma once

#include <string>

#include "pliant/molecule/read/read.hpp"

namespace pliant {

/// Everything that read_structure gives: notes and warnings in their order, then the error, or
/// title, model, atoms (serial, chain, residue, name, element, x y z, charge), chain ends and bonds
/// (by atom index from 1). One line each.
std::string reading_as_text(const SourceText& source, const ReadOptions& options = {});

}  // namespace pliant
