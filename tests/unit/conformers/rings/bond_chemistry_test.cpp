// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/bond_chemistry.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/frameworks.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace bond_chemistry_test {

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

}  // namespace bond_chemistry_test
}  // namespace pliant
