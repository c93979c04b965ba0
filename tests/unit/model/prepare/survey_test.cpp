// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/survey.hpp"

#include <gtest/gtest.h>

#include "unit/molecule/made_structure.hpp"

namespace pliant {
namespace survey_test {

/// Glycine 1, glycine 5 far off, a serine without OG, water, zinc, chloride, a ligand.
Structure mixed() {
  Structure s;
  test::add_residue(s, "GLY", 1, test::glycine({0, 0, 0}));
  test::add_residue(s, "GLY", 5, test::glycine({20, 0, 0}));
  auto serine = test::glycine({40, 0, 0});
  serine.push_back({"CB", "C", {42.0, -0.8, 1.2}});
  test::add_residue(s, "SER", 6, serine);
  test::add_residue(s, "HOH", 7, test::water({0, 20, 0}), "W");
  test::add_residue(s, "ZN", 8, {{"ZN", "ZN", {0, 30, 0}}}, "W");
  test::add_residue(s, "CL", 9, {{"CL", "CL", {0, 40, 0}}}, "W");
  test::add_residue(s, "LIG", 10, {{"C1", "C", {0, 50, 0}}, {"C2", "C", {1.5, 50, 0}}}, "W");
  perceive_bonds(s);
  return s;
}

TEST(Survey, CountsWhatThereIs) {
  const Survey found = survey(mixed());
  EXPECT_EQ(found.amino_acids, 3U);
  EXPECT_EQ(found.nucleotides, 0U);
  EXPECT_EQ(found.waters, 1U);
  EXPECT_EQ(found.hydrogens, 2U);
  EXPECT_EQ(found.without_hydrogens, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(found.metals, (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(found.ions, (std::vector<std::uint32_t>{5}));
  EXPECT_EQ(found.ligands, (std::vector<std::uint32_t>{6}));
  EXPECT_FALSE(found.is_ca_only || found.has_confidence);
}

TEST(Survey, NamesWhatIsMissing) {
  const Structure s = mixed();
  const Survey found = survey(s);
  ASSERT_EQ(found.incomplete.size(), 1U);
  EXPECT_EQ(found.incomplete[0].residue, 2U);
  EXPECT_EQ(found.incomplete[0].atoms, "OG");
  ASSERT_EQ(found.breaks.size(), 2U);
  EXPECT_EQ(found.breaks[0].before, 0U);
  EXPECT_EQ(found.breaks[0].after, 1U);
  EXPECT_EQ(missing_parts(s, found).size(), 2U);
  EXPECT_EQ(found_parts(s, found).size(), 3U);
}

TEST(Survey, LabelsAreShortAndListsEnd) {
  const Structure s = mixed();
  EXPECT_EQ(residue_label(s.atoms, 2), "A:SER6");
  EXPECT_EQ(listed_residues(s.atoms, {0, 1}), "A:GLY1, A:GLY5");
  EXPECT_EQ(listed_residues(s.atoms, {0, 1, 2}, 1), "A:GLY1 and 2 more");
}

TEST(Survey, OneAtomAResidueIsNoProtein) {
  Structure s;
  for (std::int64_t k = 1; k < 4; ++k)
    test::add_residue(s, "ALA", k, {{"CA", "C", {3.8 * double(k), 0, 0}}});
  perceive_bonds(s);
  EXPECT_TRUE(survey(s).is_ca_only);
}

TEST(Survey, BFactorsAreMeantOverResidues) {
  Structure s;
  test::add_residue(s, "GLY", 1, test::glycine({}));
  s.b_factors = {10.0F, 20.0F, 30.0F, 40.0F};
  EXPECT_EQ(residue_b_factors(s), std::vector<double>{25.0});
}

}  // namespace survey_test
}  // namespace pliant
