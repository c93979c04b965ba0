// SPDX-License-Identifier: MIT
// Molecules of files, for tests.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "pliant/sample/sample.hpp"
#include "support/source_folder.hpp"

namespace pliant::test {

/// With bonds perceived.
inline Structure bonded(const std::filesystem::path& file) {
  Structure structure = read_structure(file);
  perceive_bonds(structure);
  return structure;
}

struct Molecule {
  Framework framework;
  std::vector<Vec3> start;
};

/// Of a file of data/molecules, with all bonds and angles held.
inline Molecule molecule(const std::string& file, BuildOptions options = {}) {
  const Structure structure = bonded(molecule_file(file));
  options.bars = BarKind::angles;
  return {build_framework(structure, options), structure.positions};
}

/// Calls `look(molecule)` for each of data/molecules.
template <class Look>
void each_molecule(Look look) {
  for (const auto& entry : std::filesystem::directory_iterator(molecules_folder())) {
    SCOPED_TRACE(entry.path().filename().string());
    look(molecule(entry.path().filename().string()));
  }
}

/// What samples are drawn of.
struct Peptide {
  Framework framework;
  std::vector<Vec3> start;
  NetworkNodes nodes;
};

/// Of a file of data/molecules (the usual one is a ring of rings), every heavy atom a node.
inline Peptide peptide(const std::string& file = "cyclic_hexapeptide.pdb") {
  const Structure structure = bonded(molecule_file(file));
  NetworkNodes nodes;
  nodes.of_joint.assign(structure.size(), no_node);
  for (std::size_t k = 0; k < structure.size(); ++k) {
    if (structure.atoms.elements[k] == 1) continue;
    nodes.of_joint[k] = static_cast<std::uint32_t>(nodes.positions.size());
    nodes.chain.push_back(nodes.of_joint[k]);
    nodes.positions.push_back(structure.positions[k]);
  }
  return {build_framework(structure, {.bars = BarKind::angles}), structure.positions, nodes};
}

}  // namespace pliant::test
