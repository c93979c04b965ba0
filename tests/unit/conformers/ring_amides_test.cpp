// SPDX-License-Identifier: MIT
// Amides in large rings: a cyclic hexapeptide (18 atoms) with one proline, whose amide is tertiary.
#include <algorithm>
#include <cmath>
#include <set>

#include "pliant/conformers/torsions/torsion_moves.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::ring_amides_test {

struct Peptide {
  explicit Peptide(ConformerMoves asked = {})
      : moves_asked(asked),
        framework(conformer_framework(model.framework, model.positions, asked)),
        plan(*conformer_plan(framework, model.positions, asked)),
        moves(framework, plan, model.positions, asked) {}

  MolecularModel model = build_model(test::bonded(molecule_file("cyclic_hexapeptide.pdb")),
                                     {.kind = ModelKind::molecule});
  ConformerMoves moves_asked;
  Framework framework;
  BodyPlan plan;
  TorsionMoves moves;
};

/// Carbon and nitrogen of the amides in the ring.
std::vector<Bar> amides_of(const BondChemistry& chemistry, bool is_tertiary) {
  std::vector<Bar> found;
  for (Joint c = 0; c < chemistry.atoms(); ++c)
    for (const Link& bond : chemistry.bonds_at(c))
      if (chemistry.is_ring_amide(c, bond.node, is_tertiary)) found.push_back({c, bond.node});
  return found;
}

/// Cosine of the torsion of the ring about an amide.
double cosine_at(const BondChemistry& chemistry, Bar amide, std::span<const Vec3> x) {
  const Vec3 a = x[chemistry.reference(amide.a, amide.b)], b = x[amide.a], c = x[amide.b],
             d = x[chemistry.reference(amide.b, amide.a)];
  const Vec3 one = cross(b - a, c - b), other = cross(c - b, d - c);
  return dot(one, other) / (norm(one) * norm(other));
}

/// Signs of the volumes at all atoms with four bonds.
std::vector<bool> hands(const BondChemistry& chemistry, std::span<const Vec3> x) {
  std::vector<bool> signs;
  for (Joint atom = 0; atom < chemistry.atoms(); ++atom) {
    const auto at = chemistry.bonds_at(atom);
    if (at.size() < 4) continue;
    const Vec3 here = x[atom];
    signs.push_back(dot(cross(x[at[0].node] - here, x[at[1].node] - here), x[at[2].node] - here) >
                    0.0);
  }
  return signs;
}

/// States of the amides in 40 draws, all whole and of the same hands; those that turn are flat.
std::set<std::vector<bool>> states_of(const Peptide& peptide, std::span<const Bar> amides) {
  const BondChemistry chemistry(peptide.model.framework, peptide.model.positions);
  const double flat = std::cos(15.0 * std::numbers::pi / 180.0);
  std::set<std::vector<bool>> states;
  for (std::uint64_t k = 0; k < 40; ++k) {
    std::vector<Vec3> x = peptide.model.positions;
    RandomSequence draws({.seed = k});
    peptide.moves.draw_loops(draws, k % 4 == 3 ? TorsionDraw::uniform : TorsionDraw::preferred, x);
    EXPECT_LT(test::worst_bar(peptide.framework, x), 1e-9);
    EXPECT_EQ(hands(chemistry, x), hands(chemistry, peptide.model.positions));
    std::vector<bool> is_cis;
    for (const Bar amide : amides) {
      const double cosine = cosine_at(chemistry, amide, x);
      if (chemistry.is_ring_amide(amide.a, amide.b, !peptide.moves_asked.secondary_amides))
        EXPECT_GT(std::abs(cosine), flat);  // one that stays is twisted by 21 degrees
      is_cis.push_back(cosine > 0.0);
    }
    states.insert(is_cis);
  }
  return states;
}

TEST(RingAmides, TertiaryOnesTurn) {
  const Peptide peptide;
  const BondChemistry chemistry(peptide.model.framework, peptide.model.positions);
  const std::vector<Bar> tertiary = amides_of(chemistry, true);
  EXPECT_EQ(amides_of(chemistry, false).size(), 6U);
  ASSERT_EQ(tertiary.size(), 1U);
  EXPECT_EQ(states_of(peptide, tertiary).size(), 2U);
}

TEST(RingAmides, SecondaryOnesStayUnlessAsked) {
  const Peptide peptide;
  const BondChemistry chemistry(peptide.model.framework, peptide.model.positions);
  std::vector<Bar> secondary = amides_of(chemistry, false);
  std::erase_if(secondary, [&](Bar at) { return chemistry.is_ring_amide(at.a, at.b, true); });
  ASSERT_EQ(secondary.size(), 5U);
  EXPECT_EQ(states_of(peptide, secondary).size(), 1U);
  EXPECT_GT(states_of(Peptide({.secondary_amides = true}), secondary).size(), 3U);
}

TEST(RingAmides, AreRigidWhileConformersAreResolved) {
  const Peptide peptide;
  const auto loose = drawing_plan(peptide.framework, peptide.model.positions);
  ASSERT_TRUE(loose.has_value());
  EXPECT_EQ(loose->bodies().size(), peptide.plan.bodies().size() + 1);
  const MolecularModel crown = test::model_of("crown_18_6.cif");
  EXPECT_FALSE(drawing_plan(crown.framework, crown.positions).has_value());
}

}  // namespace pliant::ring_amides_test
