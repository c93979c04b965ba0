// SPDX-License-Identifier: MIT
// Molecules of files, for tests.
#pragma once

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
