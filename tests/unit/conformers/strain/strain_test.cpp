// SPDX-License-Identifier: MIT
// Gradients by differences, and where relaxing ends.
#include "pliant/conformers/strain/strain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "pliant/conformers/strain/conformer_energy.hpp"
#include "pliant/conformers/strain/relaxation.hpp"
#include "pliant/conformers/strain/torsion_gradient.hpp"
#include "support/frameworks.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace strain_test {

/// The largest difference of a gradient from central differences.
double worst_slope(const EnergyOf& energy, std::vector<Vec3> x) {
  std::vector<Vec3> gradient(x.size()), unused(x.size());
  energy(x, gradient);
  constexpr double step = 1e-5;
  double worst = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double was = x[k].*axis;
      x[k].*axis = was + step;
      const double above = energy(x, unused);
      x[k].*axis = was - step;
      const double below = energy(x, unused);
      x[k].*axis = was;
      worst = std::max(worst, std::abs((above - below) / (2.0 * step) - gradient[k].*axis));
    }
  return worst;
}

struct Strained {
  explicit Strained(const char* file)
      : model(test::model_of(file)),
        chemistry(model.framework, model.positions),
        strain(model.framework, chemistry, model.positions, model.positions) {}
  EnergyOf energy() const {
    return [this](std::span<const Vec3> x, std::span<Vec3> g) { return strain.at(x, g); };
  }
  MolecularModel model;
  BondChemistry chemistry;
  Strain strain;
};

TEST(Strain, ItsGradientIsThatOfDifferences) {
  for (const char* file : {"butane.sdf", "aspirin.sdf", "cyclohexane_boat.xyz", "glucose.cif"}) {
    const Strained molecule(file);
    const auto x = test::shake(molecule.model.framework, molecule.model.positions, 0.1);
    EXPECT_LT(worst_slope(molecule.energy(), x), 2e-3) << file;
  }
}

TEST(Strain, RelaxingBringsAShakenMoleculeBackToItsLengthsAndAngles) {
  const Strained aspirin("aspirin.sdf");
  auto x = test::shake(aspirin.model.framework, aspirin.model.positions, 0.2);
  std::vector<Vec3> gradient(x.size());
  const double before = aspirin.strain.at(x, gradient);
  const double after = relax(aspirin.energy(), {.steps = 1000}, x);
  EXPECT_LT(after, before - 100.0);
  aspirin.strain.at(x, gradient);
  for (Vec3 pull : gradient) EXPECT_LT(norm(pull), 0.5);
  for (const Bar& bond : aspirin.model.framework.bars())
    EXPECT_NEAR(distance(x[bond.a], x[bond.b]),
                distance(aspirin.model.positions[bond.a], aspirin.model.positions[bond.b]), 0.15);
}

TEST(Relaxation, FindsTheMinimumOfAQuadraticForm) {
  const Vec3 goal{1.0, -2.0, 0.5};
  const EnergyOf bowl = [&](std::span<const Vec3> x, std::span<Vec3> gradient) {
    double sum = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double stiffness = 1.0 + 40.0 * double(k);
      gradient[k] = 2.0 * stiffness * (x[k] - goal);
      sum += stiffness * norm_squared(x[k] - goal);
    }
    return sum;
  };
  std::vector<Vec3> x(5);
  EXPECT_LT(relax(bowl, {.least_gradient = 1e-6}, x), 1e-10);
  for (Vec3 at : x) EXPECT_LT(distance(at, goal), 1e-5);
}

TEST(TorsionGradient, IsNoneOnALine) {
  EXPECT_FALSE(torsion_gradient({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}).has_value());
  const auto right = torsion_gradient({0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 1});
  ASSERT_TRUE(right.has_value());
  EXPECT_NEAR(right->cosine, 0.0, 1e-15);
  EXPECT_NEAR(std::abs(right->sine), 1.0, 1e-15);
}

TEST(ConformerEnergy, AChairHasLessThanABoatAndStaggeredLessThanEclipsed) {
  const MolecularModel chair = test::model_of("cyclohexane_chair.xyz");
  const MolecularModel boat = test::model_of("cyclohexane_boat.xyz");
  const auto energy = [](const MolecularModel& model) {
    const BondChemistry chemistry(model.framework, model.positions);
    return ConformerEnergy(model.framework, chemistry).at(model.positions);
  };
  EXPECT_LT(energy(chair) + 2.0, energy(boat));
}

}  // namespace strain_test
}  // namespace pliant
