// SPDX-License-Identifier: MIT
#include "pliant/model/model.hpp"

#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"
#include "pliant/model/contacts/hydrogen_bonds.hpp"
#include "pliant/model/steric_table.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/molecule/made_structure.hpp"

namespace pliant::model_test {

using namespace test;
using testing::ElementsAre;

/// N-H..O=C in a line, H on an N with two C; other methyl groups nearby.
Structure amide_and_carbonyl() {
  Structure s;
  add_residue(s, "LIG", 1,
              {{"N", "N", {0, 0, 0}},
               {"H", "H", {1.0, 0, 0}},
               {"C1", "C", {-0.7, 1.2, 0}},
               {"C2", "C", {-0.7, -1.2, 0}}});
  add_residue(s, "LIG", 5,
              {{"O", "O", {2.8, 0, 0}},
               {"C", "C", {4.0, 0, 0}},
               {"C3", "C", {4.7, 1.3, 0}},
               {"C4", "C", {4.7, -1.3, 0}}});
  perceive_bonds(s);
  return s;
}

TEST(HydrogenBonds, OneInALineHasTheWholeWell) {
  const auto found = hydrogen_bonds(amide_and_carbonyl());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].kind, MolecularContactKind::hydrogen_bond);
  EXPECT_EQ(found[0].a, 0U);
  EXPECT_EQ(found[0].b, 4U);
  EXPECT_EQ(found[0].hydrogen, 1U);
  EXPECT_EQ(found[0].base, 5U);
  EXPECT_NEAR(found[0].energy, -8.0, 1e-9);
}

TEST(HydrogenBonds, TheCutoffLeavesWeakOnesOut) {
  EXPECT_TRUE(hydrogen_bonds(amide_and_carbonyl(), {.cutoff = -8.5}).empty());
}

/// Lysine's N in the origin, its hydrogens, and a carboxylate with its nearer O that far along x.
Structure ammonium_and_carboxylate(double apart) {
  Structure s;
  add_residue(s, "LYS", 1,
              {{"CE", "C", {-1.5, 0, 0}},
               {"NZ", "N", {0, 0, 0}},
               {"HZ1", "H", {0.95, 0.3, 0}},
               {"HZ2", "H", {-0.3, -0.5, 0.85}},
               {"HZ3", "H", {-0.3, -0.5, -0.85}}});
  add_residue(s, "ASP", 9,
              {{"OD1", "O", {apart, 0, 0}},
               {"CG", "C", {apart + 0.8, 1.0, 0}},
               {"OD2", "O", {apart + 0.2, 2.1, 0}},
               {"CB", "C", {apart + 2.3, 0.9, 0}}});
  perceive_bonds(s);
  return s;
}

TEST(HydrogenBonds, AChargedPairIsASaltBridge) {
  const auto found = hydrogen_bonds(ammonium_and_carboxylate(2.8));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].kind, MolecularContactKind::salt_bridge);
  EXPECT_NEAR(found[0].energy, salt_bridge_energy(2.8), 1e-12);
}

TEST(HydrogenBonds, ASaltBridgeIsNoLongerThanFourAngstrom) {
  EXPECT_LT(salt_bridge_energy(4.1), HydrogenBondOptions{}.cutoff);
  EXPECT_EQ(hydrogen_bonds(ammonium_and_carboxylate(3.95)).size(), 1U);
  EXPECT_TRUE(hydrogen_bonds(ammonium_and_carboxylate(4.05)).empty());
}

/// MolProbity's spheres overlap by 0.4 Angstrom in a clash; steps end 0.02 within least distances.
/// No clash: two of N, O and S, one of which has a hydrogen.
TEST(StericTable, KeepsHeavyAtomsFromClashing) {
  const Sterics sterics = molecular_sterics(amide_and_carbonyl());
  EXPECT_NO_THROW(check(sterics, 8));
  const std::vector<std::string_view> kinds = steric_kind_names();
  const std::map<std::string_view, double> radii{{"C", 1.70}, {"N", 1.55},  {"NH", 1.55},
                                                 {"O", 1.52}, {"OH", 1.52}, {"S", 1.80}};
  const auto has_hydrogen = [](std::string_view kind) { return kind == "NH" || kind == "OH"; };
  std::size_t pairs = 0;
  for (std::size_t a = 0; a < kinds.size(); ++a)
    for (std::size_t b = 0; b < kinds.size(); ++b) {
      if (!radii.contains(kinds[a]) || !radii.contains(kinds[b])) continue;
      ++pairs;
      const bool may_bond =
          kinds[a] != "C" && kinds[b] != "C" && (has_hydrogen(kinds[a]) || has_hydrogen(kinds[b]));
      const double clash = radii.at(kinds[a]) + radii.at(kinds[b]) - 0.4;
      EXPECT_GE(sterics.least[a * sterics.kind_count + b], may_bond ? 2.6 : clash + 0.02 - 1e-9)
          << kinds[a] << ".." << kinds[b];
    }
  EXPECT_EQ(pairs, radii.size() * radii.size());
}

std::string_view kind_name(const Structure& s, std::uint32_t atom) {
  return steric_kind_names()[molecular_sterics(s).kinds[atom]];
}

/// A proline and a serine after it as they are with polar hydrogens, and a ligand.
TEST(StericTable, TellsOxygenWithHydrogenFromOxygenThatOnlyAccepts) {
  Structure s;
  add_residue(s, "PRO", 1, {{"N", "N", {0, 0, 0}}, {"C", "C", {2, 1, 0}}, {"O", "O", {2, 2.2, 0}}});
  add_residue(s, "SER", 2,
              {{"CB", "C", {9, 0, 0}}, {"OG", "O", {10.4, 0, 0}}, {"HG", "H", {10.8, 0.9, 0}}});
  add_residue(s, "LIG", 3, {{"C", "C", {20, 0, 0}}, {"O", "O", {21.2, 0, 0}}});
  perceive_bonds(s);
  EXPECT_EQ(kind_name(s, 0), "N");
  EXPECT_EQ(kind_name(s, 2), "O");
  EXPECT_EQ(kind_name(s, 4), "OH");
  EXPECT_EQ(kind_name(s, 7), "OH") << "a ligand without hydrogens: they may have been left out";
}

TEST(StericTable, AnyOxygenMayDonateWhereAllHydrogensAreLeftOut) {
  Structure s;
  add_residue(s, "ALA", 1, {{"N", "N", {0, 0, 0}}, {"C", "C", {2, 1, 0}}, {"O", "O", {2, 2.2, 0}}});
  perceive_bonds(s);
  EXPECT_EQ(kind_name(s, 0), "NH");
  EXPECT_EQ(kind_name(s, 2), "OH");
}

TEST(BuildModel, StartsWithEveryLimitAndDistanceHeld) {
  const MolecularModel model = build_model(amide_and_carbonyl());
  for (const Limit& limit : model.framework.limits())
    EXPECT_EQ(excess(limit, distance(model.positions[limit.a], model.positions[limit.b])), 0.0);
  EXPECT_TRUE(own_distances(model.framework, model.positions).empty());
  EXPECT_EQ(model.framework.limits().size(), 3U);
}

TEST(BuildModel, KindsAddUp) {
  const Structure s = amide_and_carbonyl();
  const auto bonds = build_model(s, {.kind = ModelKind::bonds}).framework.bar_count();
  const MolecularModel molecule = build_model(s, {.kind = ModelKind::molecule});
  EXPECT_EQ(bonds, s.bonds.size());
  EXPECT_GT(molecule.framework.bar_count(), bonds);
  EXPECT_TRUE(molecule.framework.limits().empty());
  EXPECT_NE(molecule.framework.sterics(), nullptr);
  EXPECT_EQ(build_model(s, {.kind = ModelKind::angles}).framework.sterics(), nullptr);
}

TEST(BuildModel, TakesContactsInPlaceOfItsOwn) {
  ModelOptions options{.contacts = std::vector<MolecularContact>{}};
  EXPECT_TRUE(build_model(amide_and_carbonyl(), options).framework.limits().empty());
  options.contacts->push_back({MolecularContactKind::hydrophobic, 2, 77});
  EXPECT_ERROR(InputError, "contact 0 names atom 77 of 8 (counted from 0)",
               build_model(amide_and_carbonyl(), options));
}

TEST(UsualModel, IsToldByResidues) {
  Structure s;
  add_residue(s, "GLY", 1, glycine({0, 0, 0}));
  EXPECT_EQ(usual_model(s), ModelKind::molecule) << "an amino acid alone is a ligand";
  add_residue(s, "GLY", 2, glycine({8, 0, 0}));
  EXPECT_EQ(usual_model(s), ModelKind::protein);
  EXPECT_EQ(usual_model(amide_and_carbonyl()), ModelKind::molecule);
}

std::map<std::string_view, long> kinds_of(const Structure& structure) {
  const auto names = steric_kind_names();
  std::map<std::string_view, long> counts;
  for (const std::uint16_t kind : molecular_sterics(structure, false).kinds) ++counts[names[kind]];
  return counts;
}

TEST(StericTable, KindsFollowElementsAndHydrogens) {
  EXPECT_EQ(kinds_of(test::model_of("butane.sdf").structure),
            (std::map<std::string_view, long>{{"C", 4}, {"HC", 10}}));
  EXPECT_EQ(kinds_of(test::model_of("aspirin.sdf").structure),
            (std::map<std::string_view, long>{{"C", 9}, {"H", 1}, {"HC", 7}, {"O", 3}, {"OH", 1}}));
}

TEST(StericTable, IsSymmetricAndThatOfThePages) {
  const Structure butane = test::model_of("butane.sdf").structure;
  const Sterics usual = molecular_sterics(butane, false), careful = molecular_sterics(butane, true);
  const auto names = steric_kind_names();
  const auto at = [&](const Sterics& table, std::string_view a, std::string_view b) {
    const auto row = [&](std::string_view name) {
      return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
    };
    return table.least[row(a) * table.kind_count + row(b)];
  };
  for (std::string_view a : names)
    for (std::string_view b : names) EXPECT_EQ(at(careful, a, b), at(careful, b, a)) << a << b;
  EXPECT_EQ(at(usual, "C", "C"), 3.2);
  EXPECT_EQ(at(usual, "O", "H"), 1.7);
  EXPECT_EQ(at(usual, "HC", "HC"), 2.0);
  EXPECT_EQ(at(careful, "HC", "HC"), 2.06);
  EXPECT_EQ(at(careful, "HC", "C"), 2.54);
  EXPECT_EQ(at(careful, "C", "C"), 3.2);
}

/// B = 8 pi^2 <u^2> / 3: 26.3 Angstrom^2 is a fluctuation of 1 Angstrom.
TEST(Amplitude, OfBFactorsIsTheMeanFluctuation) {
  Structure s;
  for (int k = 0; k < 2; ++k) test::add_residue(s, "GLY", k + 1, test::glycine({20.0 * k, 0, 0}));
  s.b_factors.assign(8, 5.0F);
  s.b_factors[1] = 26.318945F;      // 1 Angstrom
  s.b_factors[5] = 4 * 26.318945F;  // 2 Angstrom
  EXPECT_NEAR(b_factor_amplitude(s, {}).value, 1.5, 1e-6);
  EXPECT_EQ(choose_amplitude("2.5", s, {}).value, 2.5);
  EXPECT_ERROR(
      OptionError,
      "amplitude: expected a number above 0 (Angstrom), bfactors, or a file with models of "
      "the molecule; found 0",
      choose_amplitude("0", s, {}));
  s.b_factors.clear();
  EXPECT_TRUE(test::error_text<OptionError>([&] {
                b_factor_amplitude(s, {});
              }).starts_with("amplitude bfactors: "));
}

}  // namespace pliant::model_test
