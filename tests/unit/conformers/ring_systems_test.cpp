// SPDX-License-Identifier: MIT
// Rings and systems of them in molecules whose rings are known.
#include "pliant/conformers/rings/ring_systems.hpp"

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/rings/distance_fit.hpp"
#include "pliant/conformers/rings/ring_forms.hpp"
#include "pliant/conformers/rings/ring_moves.hpp"
#include "pliant/conformers/rings/ring_pucker.hpp"
#include "pliant/conformers/rings/system_forms.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::ring_systems_test {

struct Molecule {
  explicit Molecule(const char* file)
      : model(test::model_of(file)), chemistry(model.framework, model.positions) {}
  template <class Is>
  long count(Is is) const {
    long count = 0;
    for (Joint a = 0; a < model.positions.size(); ++a) count += is(a) ? 1 : 0;
    return count;
  }
  /// Of bonds, in this direction or the other.
  template <class Is>
  long count_bonds(Is is) const {
    return count([&](Joint a) {
      const auto bonds = chemistry.bonds_at(a);
      return std::any_of(bonds.begin(), bonds.end(),
                         [&](const Link& at) { return is(a, at.node); });
    });
  }
  MolecularModel model;
  BondChemistry chemistry;
};

TEST(RingSystems, AreMadeOfSmallRingsThatShareBonds) {
  const Molecule adamantane("adamantane.mol"), cholesterol("cholesterol.cif");
  ASSERT_EQ(ring_systems(adamantane.chemistry).size(), 1U);
  EXPECT_EQ(ring_systems(adamantane.chemistry)[0].atoms.size(), 10U);
  ASSERT_EQ(ring_systems(cholesterol.chemistry).size(), 1U);
  EXPECT_EQ(ring_systems(cholesterol.chemistry)[0].atoms.size(), 17U);
  EXPECT_EQ(ring_systems(cholesterol.chemistry)[0].rings.size(), 4U);
  for (const char* file : {"butane.sdf", "benzene.sdf", "cyclohexane_chair.xyz", "crown_18_6.cif"})
    EXPECT_TRUE(ring_systems(Molecule(file).chemistry).empty()) << file;
}

TEST(SystemForms, AdamantaneHasOneCholesterolSeveralWithItsBonds) {
  for (const auto& [file, is_rigid] :
       {std::pair("adamantane.mol", true), std::pair("cholesterol.cif", false)}) {
    const Molecule at(file);
    const RingSystem system = ring_systems(at.chemistry)[0];
    const auto forms = system_forms(system, at.model.framework, at.chemistry, at.model.positions);
    EXPECT_EQ(forms.size() == 1, is_rigid) << file;
    for (const RingForm& form : forms)
      for (std::size_t k = 0; k < system.atoms.size(); ++k)
        for (std::size_t other : system.neighbours[k])
          EXPECT_NEAR(distance(form.positions[k], form.positions[other]),
                      distance(at.model.positions[system.atoms[k]],
                               at.model.positions[system.atoms[other]]),
                      1e-9);
  }
}

TEST(RingPucker, RingsThatLieInAPlaneDoNot) {
  const auto count = [](const char* file) {
    const Molecule at(file);
    return puckered_rings(at.chemistry, at.model.positions).size();
  };
  EXPECT_EQ(count("cyclohexane_chair.xyz"), 1U);
  EXPECT_EQ(count("glucose.cif"), 1U);
  EXPECT_EQ(count("benzene.sdf"), 0U);
  EXPECT_EQ(count("butane.sdf"), 0U);
}

/// At each carbon one angle of the ring and four of a bond of it and a hydrogen.
TEST(RingPucker, AnglesOfCyclohexaneGiveWay) {
  const Molecule at("cyclohexane_chair.xyz");
  const auto rings = puckered_rings(at.chemistry, at.model.positions);
  EXPECT_EQ(ring_angles(rings[0], at.chemistry).size(), 30U);
  EXPECT_EQ(soft_pairs(at.model.framework, at.chemistry, at.model.positions, true).size(), 30U);
}

TEST(RingMoves, AFormLeavesBondsAndHandednessOfWhatHangsOnTheRing) {
  const Molecule at("glucose.cif");
  const auto rings =
      flexible_rings(at.model.framework, at.chemistry, at.model.positions, {.systems = true});
  ASSERT_EQ(rings.size(), 1U);
  ASSERT_GT(rings[0].forms.size(), 1U);
  const auto volume = [&](std::span<const Vec3> x, Joint atom) {
    const auto bonds = at.chemistry.bonds_at(atom);
    return dot(cross(x[bonds[0].node] - x[atom], x[bonds[1].node] - x[atom]),
               x[bonds[2].node] - x[atom]);
  };
  for (const RingForm& form : rings[0].forms) {
    std::vector<Vec3> x = at.model.positions;
    take_form(rings[0], form, x);
    for (Joint a = 0; a < x.size(); ++a) {
      for (const Link& bond : at.chemistry.bonds_at(a))
        EXPECT_NEAR(distance(x[a], x[bond.node]),
                    distance(at.model.positions[a], at.model.positions[bond.node]), 1e-9);
      if (at.chemistry.bonds_at(a).size() < 4) continue;
      EXPECT_GT(volume(x, a) * volume(at.model.positions, a), 0.0) << a;
    }
  }
}

/// Bars across angles are no bonds.
TEST(BondChemistry, FindsTheBondsAmongBars) {
  const Molecule aspirin("aspirin.sdf");
  for (const Bond& bond : aspirin.model.structure.bonds)
    EXPECT_TRUE(aspirin.chemistry.is_bonded(bond.a, bond.b));
  long ends = 0;
  for (Joint a = 0; a < aspirin.model.positions.size(); ++a)
    ends += static_cast<long>(aspirin.chemistry.bonds_at(a).size());
  EXPECT_EQ(ends, 2 * static_cast<long>(aspirin.model.structure.bonds.size()));
}

TEST(BondChemistry, KnowsAspirin) {
  const Molecule at("aspirin.sdf");
  const BondChemistry& c = at.chemistry;
  EXPECT_EQ(at.count([&](Joint a) { return c.is_aryl(a); }), 6);
  EXPECT_EQ(at.count([&](Joint a) { return c.is_acyl(a); }), 2);
  EXPECT_EQ(at.count([&](Joint a) { return c.is_tetrahedral(a) && c.bonds_at(a).size() == 4; }), 1);
  EXPECT_EQ(at.count_bonds([&](Joint a, Joint b) { return c.is_ester(a, b); }), 1);
  EXPECT_EQ(at.count_bonds([&](Joint a, Joint b) { return c.is_tertiary_amide(a, b); }), 0);
  ASSERT_EQ(c.simple_rings().size(), 1U);
  EXPECT_EQ(c.simple_rings()[0].size(), 6U);
}

TEST(BondChemistry, MethylsSpinAlike) {
  const Molecule at("butane.sdf");
  EXPECT_EQ(at.count_bonds([&](Joint a, Joint b) { return at.chemistry.spins_alike(a, b); }), 2);
}

/// It once read elements that were not there.
TEST(BondChemistry, OfJointsWithoutNamesNothingIsKnown) {
  const MolecularModel model = test::model_of("butane.sdf");
  const Framework nameless(test::parts_of(model.framework));
  const BondChemistry chemistry(nameless, model.positions);
  for (Joint a = 0; a < nameless.joint_count(); ++a) {
    EXPECT_TRUE(chemistry.bonds_at(a).empty());
    EXPECT_FALSE(chemistry.is_hydrogen(a) || chemistry.is_in_ring(a) || chemistry.accepts(a));
  }
  EXPECT_TRUE(chemistry.simple_rings().empty());
}

constexpr double bond = 1.54;  // Angstrom

/// The chair of cyclohexane with tetrahedral angles; flat where `height` is 0.
std::vector<Vec3> even_ring(double height) {
  std::vector<Vec3> ring;
  const double radius = std::sqrt(bond * bond - 4.0 * height * height);
  for (int k = 0; k < 6; ++k)
    ring.push_back({radius * std::cos(k * std::numbers::pi / 3),
                    radius * std::sin(k * std::numbers::pi / 3), k % 2 == 0 ? height : -height});
  return ring;
}

std::vector<Vec3> boat() {
  const double x = bond / 2, y = bond * std::sqrt(2.0 / 3), over = bond / 3,
               up = bond * std::sqrt(2.0) / 3;
  return {{x + over, 0, up}, {x, y, 0}, {-x, y, 0}, {-x - over, 0, up}, {-x, -y, 0}, {x, -y, 0}};
}

double worst_change(const std::vector<Vec3>& one, const std::vector<Vec3>& other,
                    std::size_t apart) {
  double worst = 0.0;
  for (std::size_t k = 0; k < one.size(); ++k) {
    const std::size_t to = (k + apart) % one.size();
    worst = std::max(worst, std::abs(distance(one[k], one[to]) - distance(other[k], other[to])));
  }
  return worst;
}

TEST(RingForms, KnowsAChair) {
  EXPECT_TRUE(is_chair(even_ring(bond / 6)));
  EXPECT_FALSE(is_chair(boat()));
}

TEST(RingForms, AChairHasItsMirrorImageAndTwistBoats) {
  const std::vector<Vec3> chair = even_ring(bond / 6);
  const auto forms = ring_forms(chair, std::vector<bool>(6, false));
  EXPECT_EQ(forms.front().positions, chair);
  EXPECT_EQ(
      std::count_if(forms.begin(), forms.end(), [](const auto& form) { return form.is_chair; }), 2);
  EXPECT_GT(forms.size(), 3U);
  for (const RingForm& form : forms) EXPECT_LT(worst_change(form.positions, chair, 1), 1e-9);
}

/// Equal lengths and angles hold a boat, but not still: chairs are forms of it, with both
/// distances.
TEST(RingForms, ABoatTurnsIntoAChairOfTheSameAngles) {
  const auto forms = ring_forms(boat(), std::vector<bool>(6, false));
  const auto chair =
      std::find_if(forms.begin(), forms.end(), [](const auto& form) { return form.is_chair; });
  ASSERT_NE(chair, forms.end());
  EXPECT_LT(worst_change(chair->positions, even_ring(bond / 6), 1), 1e-9);
  EXPECT_LT(worst_change(chair->positions, even_ring(bond / 6), 2), 1e-9);
  EXPECT_LT(worst_change(chair->positions, even_ring(bond / 6), 3), 1e-9);
}

TEST(RingForms, AnEnvelopeOfFiveHasOthersWithItsBonds) {
  std::vector<Vec3> envelope;
  for (int k = 0; k < 5; ++k) {
    const double angle = 2.0 * k * std::numbers::pi / 5;
    envelope.push_back({1.3 * std::cos(angle), 1.3 * std::sin(angle),
                        0.4 * std::sqrt(0.4) * std::cos(2.0 * angle)});
  }
  const auto forms = ring_forms(envelope, std::vector<bool>(5, false));
  EXPECT_GT(forms.size(), 5U);
  for (const RingForm& form : forms) {
    EXPECT_FALSE(form.is_chair);
    EXPECT_LT(worst_change(form.positions, envelope, 1), 1e-9);
  }
}

const std::vector<WantedDistance> right_triangle{{0, 1, 9.0}, {1, 2, 16.0}, {0, 2, 25.0}};

TEST(DistanceFit, MeetsATriangle) {
  std::vector<Vec3> x{{0, 0, 0}, {2.5, 0.5, 0}, {3.5, 3, 1}};
  ASSERT_TRUE(meet(right_triangle, x));
  EXPECT_NEAR(distance(x[0], x[1]), 3.0, 1e-12);
  EXPECT_NEAR(distance(x[1], x[2]), 4.0, 1e-12);
  EXPECT_NEAR(distance(x[0], x[2]), 5.0, 1e-12);
}

TEST(DistanceFit, MovesThePointsAlikeAndNotTheirMiddle) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}};
  ASSERT_TRUE(meet({{0, 1, 4.0}}, x));
  EXPECT_NEAR(distance(x[0], {-0.5, 0, 0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(x[1], {1.5, 0, 0}), 0.0, 1e-12);
}

TEST(DistanceFit, GivesUpWhereNoPlaceMeetsAll) {
  std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}};
  EXPECT_FALSE(meet({{0, 1, 1.0}, {1, 2, 1.0}, {0, 2, 9.0}}, x));
}

TEST(DistanceFit, AStepSaysHowFarOffItWasAndGoesLessFarIfDamped) {
  std::vector<Vec3> free{{0, 0, 0}, {1, 0, 0}}, damped = free;
  EXPECT_DOUBLE_EQ(approach({{0, 1, 4.0}}, 0.0, free), 0.75);
  EXPECT_DOUBLE_EQ(approach({{0, 1, 4.0}}, 1.0, damped), 0.75);
  // One step of Newton: the length grows by (4 - 1) / (2 * 1), half of that where damped by 1.
  EXPECT_NEAR(distance(free[0], free[1]), 2.5, 1e-12);
  EXPECT_NEAR(distance(damped[0], damped[1]), 1.75, 1e-12);
}

}  // namespace pliant::ring_systems_test
