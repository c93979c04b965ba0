// SPDX-License-Identifier: MIT
// Hydrogens placed on the heavy atoms of files that have them, against where the files have them.
#include "pliant/model/prepare/carbon_hydrogens.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/read/read.hpp"
#include "support/source_folder.hpp"

namespace pliant {
namespace carbon_hydrogens_test {

Structure whole(const char* file) {
  Structure structure = read_structure(molecule_file(file));
  perceive_bonds(structure);
  return structure;
}

Structure without_hydrogens(const Structure& structure) {
  std::vector<bool> is_out;
  for (std::uint8_t element : structure.atoms.elements) is_out.push_back(element == 1);
  return without_atoms(structure, is_out).structure;
}

double degrees(Vec3 a, Vec3 b, Vec3 c) {
  return std::acos(dot(a - b, c - b) / (distance(a, b) * distance(c, b))) * 180 / std::numbers::pi;
}

TEST(CarbonHydrogens, AMethylIsAStaggeredTripod) {
  const Structure bare = without_hydrogens(whole("alanine_dipeptide.pdb"));
  std::map<std::uint32_t, std::vector<Vec3>> of_parent;
  for (const PlacedHydrogen& h : place_carbon_hydrogens(bare))
    of_parent[h.parent].push_back(h.position);
  ASSERT_EQ(of_parent.size(), 4U);  // two caps, CA, CB
  for (const auto& [parent, places] : of_parent) {
    ASSERT_EQ(places.size(), bare.atoms.names[parent] == "CA" ? 1U : 3U);
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_NEAR(distance(places[k], bare.positions[parent]), 1.09, 1e-12);
      for (std::size_t j = 0; j < k; ++j)
        EXPECT_NEAR(degrees(places[k], bare.positions[parent], places[j]), 109.5, 0.2);
    }
  }
}

/// As many as the file has, and as near as ideal angles come; methyls turn alike.
TEST(CarbonHydrogens, AreThoseOfAllTwentyAminoAcids) {
  const Structure file = whole("peptide_20.pdb");
  std::map<std::string, std::vector<Vec3>> expected;
  for (const Bond& bond : file.bonds)
    for (const auto& [h, carbon] : {std::pair(bond.a, bond.b), std::pair(bond.b, bond.a)})
      if (file.atoms.elements[h] == 1 && file.atoms.elements[carbon] == 6)
        expected[file.atoms.label(carbon)].push_back(file.positions[h]);
  const Structure bare = without_hydrogens(file);
  std::map<std::string, std::vector<Vec3>> placed;
  for (const PlacedHydrogen& h : place_carbon_hydrogens(bare))
    placed[bare.atoms.label(h.parent)].push_back(h.position);
  ASSERT_EQ(placed.size(), expected.size());
  for (const auto& [carbon, places] : expected) {
    ASSERT_EQ(placed[carbon].size(), places.size()) << carbon;
    for (Vec3 h : placed[carbon]) {
      double nearest = HUGE_VAL;
      for (Vec3 there : places) nearest = std::min(nearest, distance(h, there));
      EXPECT_LT(nearest, places.size() == 3 ? 0.45 : 0.25) << carbon;
    }
  }
}

TEST(CarbonHydrogens, WhatHasSomeIsLeftAlone) {
  EXPECT_TRUE(place_carbon_hydrogens(whole("peptide_20.pdb")).empty());
  EXPECT_TRUE(place_carbon_hydrogens(without_hydrogens(whole("caffeine.sdf"))).empty());
}

}  // namespace carbon_hydrogens_test
}  // namespace pliant
