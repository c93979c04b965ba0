// SPDX-License-Identifier: MIT
// Ligands in a place: which bonds turn, and which contacts are held.
#include "pliant/sample/pocket/held_contacts.hpp"
#include "pliant/sample/pocket/ligand_moves.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::ligand_test {

const MolecularModel& aspirin() {
  static const MolecularModel model = test::model_of("aspirin.sdf");
  return model;
}

std::vector<Joint> all_joints() {
  std::vector<Joint> all(aspirin().framework.joint_count());
  for (Joint k = 0; k < all.size(); ++k) all[k] = k;
  return all;
}

TEST(Ligand, TurnsItsBondsAndKeepsItsBars) {
  const Framework& framework = aspirin().framework;
  const std::vector<Vec3>& start = aspirin().positions;
  const auto plan = BodyPlan::make(framework);
  const BondChemistry chemistry(framework, start);
  const LigandMoves moves(framework, *plan, start, all_joints(), chemistry, {},
                          std::vector<bool>(start.size(), false));
  ASSERT_EQ(moves.molecules().size(), 1U);
  EXPECT_GE(moves.molecules()[0].rotors.size(), 2U);
  std::size_t redrawn = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Vec3> x = start;
    RandomSequence draws({seed, Domain::pocket, 0, 0, 0});
    if (!moves.redraw(draws, x)) continue;
    ++redrawn;
    EXPECT_TRUE(moves.fits(x));
    const auto bars = framework.bars();
    for (BarIndex b = 0; b < bars.size(); ++b)
      EXPECT_NEAR(distance(x[bars[b].a], x[bars[b].b]), framework.rest_lengths()[b], 1e-11);
  }
  EXPECT_GT(redrawn, 10U);
}

TEST(Ligand, WithoutJointsIsNone) {
  const MolecularModel peptide = test::model_of("peptide_20.pdb");
  const auto plan = BodyPlan::make(peptide.framework);
  const BondChemistry chemistry(peptide.framework, peptide.positions);
  const std::vector<bool> none(peptide.positions.size(), false);
  const LigandMoves moves(peptide.framework, *plan, peptide.positions, {}, chemistry, {}, none);
  EXPECT_TRUE(moves.molecules().empty());
}

TEST(HeldContacts, AreThoseOfTheKindsThatAreNamed) {
  const MolecularModel peptide = test::model_of("peptide_20.pdb");
  const BondChemistry chemistry(peptide.framework, peptide.positions);
  const std::vector<bool> all(peptide.positions.size(), true);
  const auto count = [&](const std::vector<std::string>& hold) {
    return std::ranges::count(held_contacts(peptide.framework, chemistry, all, hold), 1);
  };
  const auto limits = peptide.framework.limits();
  EXPECT_EQ(count({"all"}), std::ssize(limits));
  EXPECT_EQ(count({"none"}), 0);
  EXPECT_EQ(count({"hydrophobic"}),
            std::ranges::count(limits, LimitKind::hydrophobic, &Limit::kind));
  EXPECT_EQ(count({"hydrogen_bond", "salt_bridge"}),
            std::ranges::count(limits, LimitKind::hydrogen_bond, &Limit::kind));
  const std::vector<MolecularContact>& found = peptide.contacts;
  const auto bridges =
      std::ranges::count(found, MolecularContactKind::salt_bridge, &MolecularContact::kind);
  EXPECT_EQ(count({"salt_bridge"}), 3 * bridges);
}

TEST(HeldContacts, RefuseOtherWords) {
  const std::string words[] = {"hydrogen"};
  EXPECT_ERROR(OptionError,
               "hold: no kind of contact named \"hydrogen\"; known: hydrogen_bond, salt_bridge, "
               "hydrophobic, metal, cation_pi, all, none",
               check_hold(words));
}

}  // namespace pliant::ligand_test
