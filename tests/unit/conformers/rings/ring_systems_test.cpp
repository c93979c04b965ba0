// SPDX-License-Identifier: MIT
// Rings and systems of them in molecules whose rings are known.
#include "pliant/conformers/rings/ring_systems.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pliant/conformers/rings/ring_moves.hpp"
#include "pliant/conformers/rings/ring_pucker.hpp"
#include "pliant/conformers/rings/system_forms.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace ring_systems_test {

struct Molecule {
  explicit Molecule(const char* file)
      : model(test::model_of(file)), chemistry(model.framework, model.positions) {}
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

}  // namespace ring_systems_test
}  // namespace pliant
