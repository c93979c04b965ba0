// SPDX-License-Identifier: MIT
// Sampler `pocket` on a peptide: which side chains it redraws, the texts of its refusals, its bits.
#include "pliant/sample/pocket/pocket.hpp"

#include "pliant/jobs/sample_task.hpp"
#include "pliant/sample/pocket/side_chain_moves.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::pocket_test {

const MolecularModel& peptide() {
  static const MolecularModel model = test::model_of("peptide_20.pdb");
  return model;
}

Joint joint_of(std::size_t residue, std::string_view name) {
  const AtomTable& atoms = *peptide().framework.atoms();
  for (Joint k = 0; k < atoms.size(); ++k)
    if (atoms.residue_of[k] == residue && atoms.names[k] == name) return k;
  ADD_FAILURE() << residue << ":" << name;
  return 0;
}

SampleAsked asked_around(const std::string& selection, const std::string& sampler = "pocket") {
  SampleAsked asked;
  asked.options.frames = 12;
  asked.options.around = selection;
  asked.options.sampler = sampler;
  asked.options.amplitude = 0.3;
  return asked;
}

TEST(Pocket, IsWhatIsSelectedOfAProtein) {
  const Joint selected[] = {joint_of(4, "CB")};
  const Pocket pocket = pocket_around(peptide().framework, peptide().positions, selected);
  EXPECT_EQ(pocket.residues, std::vector<std::uint32_t>{4});
  EXPECT_TRUE(pocket.has_joint[joint_of(4, "CA")]);
  EXPECT_FALSE(pocket.has_joint[joint_of(5, "CA")]);
}

TEST(Pocket, RedrawsSideChainsOfThePlaceAloneAndNearRotamers) {
  const Joint selected[] = {joint_of(4, "CB"), joint_of(7, "CB"), joint_of(8, "CB")};
  const Framework& framework = peptide().framework;
  const Pocket pocket = pocket_around(framework, peptide().positions, selected);
  const auto plan = BodyPlan::make(framework);
  const SideChainMoves moves(framework, *plan, peptide().positions, pocket);
  ASSERT_EQ(moves.side_chains().size(), std::size(selected));
  std::size_t changed = 0;
  for (std::uint64_t k = 0; k < 20; ++k) {
    std::vector<Vec3> x = peptide().positions;
    RandomSequence draws({k, Domain::pocket, 0, 0, 0});
    moves.redraw(draws, 1.0, x);
    for (std::size_t j = 0; j < x.size(); ++j)
      if (x[j] != peptide().positions[j]) EXPECT_TRUE(pocket.has_joint[j]);
    const auto bars = framework.bars();
    for (BarIndex b = 0; b < bars.size(); ++b)
      EXPECT_NEAR(distance(x[bars[b].a], x[bars[b].b]), framework.rest_lengths()[b], 1e-12);
    for (const SideChain& one : moves.side_chains()) {
      const SideChainTorsion& at = one.torsions.front();
      if (x[at.beyond_b] == peptide().positions[at.beyond_b]) continue;
      ++changed;
      const double chi = torsion_angle(x[at.beyond_a], x[at.a], x[at.b], x[at.beyond_b]);
      EXPECT_LT(std::abs(off_staggered(chi)), rotamer_spread / 180.0 * std::numbers::pi + 1e-9);
    }
  }
  EXPECT_GT(changed, 5U);
}

TEST(Pocket, IsChosenByASelection) {
  const SampleTask task(subject_of(peptide()), asked_around("resid 5", "auto"));
  EXPECT_EQ(task.options().sampler, "pocket");
  task.run([&](const Frame& frame) {
    EXPECT_EQ(frame.drawn_by, DrawnBy::pocket);
    return false;
  });
}

/// r.m.s. of all frames' atoms from the start (Angstrom).
double distance_from_start(double amplitude) {
  SampleAsked asked = asked_around("resid 5");
  asked.options.amplitude = amplitude;
  asked.options.frames = 40;
  const SampleTask task(subject_of(peptide()), asked);
  double sum = 0, count = 0;
  task.run([&](const Frame& frame) {
    for (std::size_t k = 0; k < frame.positions.size(); ++k, ++count)
      sum += norm_squared(frame.positions[k] - peptide().positions[k]);
    return false;
  });
  return std::sqrt(sum / count);
}

TEST(Pocket, OpensLessWithASmallAmplitude) {
  EXPECT_LT(2 * distance_from_start(0.1), distance_from_start(1.4));
}

TEST(Pocket, RefusesWhatIsNoPlace) {
  EXPECT_ERROR(OptionError, "around: selection \"resname NAG\" names no atom",
               SampleTask(subject_of(peptide()), asked_around("resname NAG")));
  EXPECT_ERROR(OptionError, "around: goes with sampler pocket, not with modes",
               SampleTask(subject_of(peptide()), asked_around("resid 5", "modes")));
}

TEST(Pocket, RotamersOfEachTorsionAddUp) {
  for (const std::string_view residue : {"ARG", "ASN", "LEU", "PHE", "VAL", "TRP", "SER"}) {
    const std::size_t torsions = atoms_along_side_chain(residue).size() - 3;
    for (std::size_t first = 0; first < torsions; first += first == 0 ? 2 : 1) {
      int percent = 0;
      for (const Rotamer& row : rotamers_of(residue, first)) percent += row.percent;
      EXPECT_GT(percent, 80) << residue << first;
      EXPECT_LT(percent, 104) << residue << first;
    }
  }
  EXPECT_EQ(amino_acid_of("HSD"), "HIS");
  EXPECT_TRUE(atoms_along_side_chain("GLY").empty());
}

}  // namespace pliant::pocket_test
