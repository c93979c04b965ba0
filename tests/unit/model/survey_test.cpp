// SPDX-License-Identifier: MIT
#include "pliant/model/prepare/survey.hpp"

#include "pliant/model/prepare/protonation.hpp"
#include "support/test.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::survey_test {

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
  EXPECT_THAT(missing_parts(s, found),
              testing::ElementsAre("side chains: 1 residue lacks atoms: A:SER6 (OG)",
                                   "2 chain breaks: A:GLY1 - A:GLY5, A:GLY5 - A:SER6"));
  EXPECT_THAT(found_parts(s, found), testing::Contains("metals: W:ZN8"));
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

/// The ring of a histidine: ND1 at (0, 0, 0), NE2 2.2 Angstrom from it.
std::vector<test::MadeAtom> histidine() {
  return {{"CA", "C", {-2.5, 1.2, 0}}, {"CG", "C", {-0.7, 1.1, 0}}, {"ND1", "N", {0, 0, 0}},
          {"CE1", "C", {1.3, 0.3, 0}}, {"NE2", "N", {1.4, 1.7, 0}}, {"CD2", "C", {0.2, 2.2, 0}}};
}

std::string form_of(const Structure& s, const std::vector<std::string>& wanted = {}) {
  return protonation_of(s, wanted).forms.at(0);
}

Structure with_histidine(const char* name = "HIS") {
  Structure s;
  test::add_residue(s, name, 57, histidine());
  return s;
}

TEST(Protonation, HistidineFollowsItsSurroundings) {
  EXPECT_EQ(form_of(with_histidine()), "HIE");
  Structure beside_oxygen = with_histidine();
  test::add_residue(beside_oxygen, "GLY", 58, {{"O", "O", {-1, -2.5, 0}}});
  EXPECT_EQ(form_of(beside_oxygen), "HID");
  Structure at_metal = with_histidine();
  test::add_residue(at_metal, "ZN", 99, {{"ZN", "ZN", {3.0, 2.6, 0}}});
  EXPECT_EQ(form_of(at_metal), "HID");
  test::add_residue(at_metal, "ZN", 100, {{"ZN", "ZN", {-0.8, -1.8, 0}}});
  EXPECT_EQ(form_of(at_metal), "HIN");
}

TEST(Protonation, NamesAndWishesComeFirst) {
  EXPECT_EQ(form_of(with_histidine("HSD")), "HID");
  EXPECT_EQ(form_of(with_histidine("HIP")), "HIP");
  EXPECT_EQ(form_of(with_histidine(), {"HIS57:HID"}), "HID");
  const Protonation asked = protonation_of(with_histidine("HIP"), {"A:HIS57:HIE"});
  EXPECT_EQ(asked.forms[0], "HIE");
  EXPECT_TRUE(asked.is_asked_for[0]);
}

TEST(Protonation, WishesThatMeanNothingAreRefused) {
  Structure s = with_histidine();
  test::add_residue(s, "ASP", 25, {}, "A");
  test::add_residue(s, "ASP", 25, {}, "B");
  const std::pair<const char*, const char*> cases[] = {
      {"HIS57", "expected RESIDUE:FORM such as HIS57:HID or A:HIS57:HID, found \"HIS57\""},
      {"HIS58:HID", "\"HIS58:HID\": there is no residue \"HIS58\""},
      {"C:HIS57:HID", "\"C:HIS57:HID\": there is no residue \"HIS57\" in chain \"C\""},
      {"ASP25:ASH",
       "\"ASP25:ASH\": 2 residues are \"ASP25\"; say which chain, as in \"A:ASP25:ASH\""},
      {"HIS57:ASH", "\"HIS57:ASH\": ASH is a form of ASP"}};
  for (const auto& [wish, fault] : cases)
    EXPECT_ERROR(OptionError, "protonate: " + std::string(fault), protonation_of(s, {wish}));
  EXPECT_THAT(test::error_text<OptionError>([&] { protonation_of(s, {"HIS57:HIF"}); }),
              testing::StartsWith("no form of a residue named \"HIF\" (d"));
}

}  // namespace pliant::survey_test
