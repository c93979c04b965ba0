// SPDX-License-Identifier: MIT
// Whether a `pliant sample` is one for `pliant conformers`, which is a program of the Python
// package.
#pragma once

#include "command.hpp"

namespace pliant::app {

/// Returns true in three cases:
/// - an option is given that only `pliant conformers` has, such as --smiles or --starts;
/// - otherwise, if all options are known to both: an SDF is written (or continued) from an SDF, MOL
///   or SMILES file;
/// - likewise: no output is named, and the file has SMILES, is compressed, or has records besides
///   the first.
bool asks_for_conformers(const Arguments& words);

}  // namespace pliant::app
