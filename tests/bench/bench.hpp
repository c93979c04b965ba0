// SPDX-License-Identifier: MIT
// What is timed: molecules, and everything that is done with one.
#pragma once

#include <memory>
#include <string>

#include "pliant/framework/framework.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::bench {

/// A molecule file, read and ready.
struct Molecule {
  std::string name;     ///< of the file, without folder and extension
  std::string file;     ///< path
  Structure structure;  ///< with all bonds
  Framework framework;  ///< a bar for each bond, or for each bond and angle
};

using SharedMolecule = std::shared_ptr<const Molecule>;

/// Registers the reading of a file and the perception of its bonds.
void add_molecule_benchmarks(const SharedMolecule& molecule);

/// Registers every row of techniques() that applies, on the molecule displaced by 0.1 Angstrom.
void add_resolve_benchmarks(const SharedMolecule& molecule);

/// Registers the kernels that take eight walkers at once, one by one.
void add_lane_benchmarks(const SharedMolecule& molecule);

/// The same for bars across angles too, and techniques that resolve these in one pass or two.
void add_angle_benchmarks(const SharedMolecule& molecule);

/// Registers frames of technique `froda` alone and in lanes, of the molecule's usual model.
void add_froda_benchmarks(const SharedMolecule& molecule);

}  // namespace pliant::bench
