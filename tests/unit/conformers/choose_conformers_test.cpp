// SPDX-License-Identifier: MIT
// Symmetries by counting, distances by superposition, and who is chosen; gradients of strain by
// differences, and where relaxing ends.
#include "pliant/conformers/choice/choose_conformers.hpp"

#include "pliant/base/math/superposition.hpp"
#include "pliant/conformers/strain/conformer_energy.hpp"
#include "pliant/conformers/strain/relaxation.hpp"
#include "pliant/conformers/strain/strain.hpp"
#include "pliant/conformers/strain/torsion_gradient.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::choose_conformers_test {

struct Symmetric {
  explicit Symmetric(const char* file)
      : model(test::model_of(file)),
        chemistry(model.framework, model.positions),
        found(symmetries(model.framework, chemistry)) {}
  MolecularModel model;
  BondChemistry chemistry;
  Symmetries found;
};

TEST(Symmetries, AreThoseOfTheGraphOfHeavyAtoms) {
  EXPECT_EQ(Symmetric("benzene.sdf").found.maps.size(), 12U);
  EXPECT_EQ(Symmetric("butane.sdf").found.maps.size(), 2U);
  EXPECT_EQ(Symmetric("caffeine.sdf").found.maps.size(), 1U);
  EXPECT_EQ(Symmetric("aspirin.sdf").found.maps.size(), 2U);  // of the acid
  EXPECT_EQ(Symmetric("adamantane.mol").found.maps.size(), 24U);
  EXPECT_TRUE(Symmetric("adamantane.mol").found.is_complete);
  const Symmetries fullerene = Symmetric("c60.xyz").found;
  EXPECT_EQ(fullerene.maps.size(), 64U);  // of 120
  EXPECT_FALSE(fullerene.is_complete);
}

TEST(Symmetries, KeepBondsAndBeginWithNone) {
  const Symmetric molecule("adamantane.mol");
  const auto& [heavy, maps, is_complete] = molecule.found;
  for (std::size_t k = 0; k < heavy.size(); ++k) EXPECT_EQ(maps[0][k], k);
  for (const auto& map : maps)
    for (std::size_t a = 0; a < heavy.size(); ++a)
      for (std::size_t b = 0; b < heavy.size(); ++b)
        EXPECT_EQ(molecule.chemistry.is_bonded(heavy[a], heavy[b]),
                  molecule.chemistry.is_bonded(heavy[map[a]], heavy[map[b]]));
}

/// By turning one onto the other for each symmetry.
double slow_distance(const Symmetries& found, std::span<const Vec3> one,
                     std::span<const Vec3> other) {
  double least = HUGE_VAL;
  for (const auto& map : found.maps) {
    std::vector<Vec3> a, b;
    for (std::size_t k = 0; k < found.heavy.size(); ++k) {
      a.push_back(one[found.heavy[k]]);
      b.push_back(other[found.heavy[map[k]]]);
    }
    const RigidMotion onto = superposition(a, b);
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += norm_squared(onto(a[k]) - b[k]);
    least = std::min(least, std::sqrt(sum / double(a.size())));
  }
  return least;
}

TEST(ShapeDistances, AreThoseOfSuperposition) {
  for (const char* file : {"butane.sdf", "benzene.sdf", "aspirin.sdf", "glucose.cif"}) {
    const Symmetric molecule(file);
    ShapeDistances shapes(molecule.found);
    std::vector<std::vector<Vec3>> x{molecule.model.positions};
    for (std::uint64_t seed = 1; seed < 4; ++seed)
      x.push_back(test::moved_rigidly(
          test::shake(molecule.model.framework, x[0], 0.5 * double(seed), seed)));
    for (const auto& one : x) shapes.add(one);
    for (std::size_t a = 0; a < x.size(); ++a)
      for (std::size_t b = 0; b < x.size(); ++b) {
        const double exact = slow_distance(molecule.found, x[a], x[b]);
        EXPECT_NEAR(shapes.between(a, b), exact, 1e-6) << file;
        EXPECT_NEAR(shapes.between(a, b, exact + 1e-6), exact, 1e-6);
        if (exact > 1e-3) EXPECT_EQ(shapes.between(a, b, exact - 1e-6), HUGE_VAL);
      }
  }
}

TEST(ShapeDistances, MirrorImagesAreNotAlike) {
  const Symmetric glucose("glucose.cif");
  std::vector<Vec3> mirrored = glucose.model.positions;
  for (Vec3& at : mirrored) at.x = -at.x;
  ShapeDistances shapes(glucose.found);
  shapes.add(glucose.model.positions);
  shapes.add(mirrored);
  EXPECT_NEAR(shapes.between(0, 1), slow_distance(glucose.found, glucose.model.positions, mirrored),
              1e-6);
  EXPECT_GT(shapes.between(0, 1), 0.3);
}

TEST(ChooseConformers, TheLowestThenLowOnesThatDiffer) {
  const Symmetric butane("butane.sdf");
  ShapeDistances shapes(butane.found);
  for (int k = 0; k < 2; ++k) shapes.add(butane.model.positions);  // alike
  shapes.add(test::shake(butane.model.framework, butane.model.positions, 2.0, 1));
  shapes.add(test::shake(butane.model.framework, butane.model.positions, 2.0, 2));
  const std::vector<double> energies{1.0, 0.5, 3.0, 2.0};
  using Numbers = std::vector<std::size_t>;
  EXPECT_EQ(choose_conformers(shapes, energies, {.most = 9, .rms = 0.3}), (Numbers{1, 3, 2}));
  EXPECT_EQ(choose_conformers(shapes, energies, {.most = 9, .rms = 0.3, .window = 1.5}),
            (Numbers{1, 3}));
  EXPECT_EQ(choose_conformers(shapes, energies, {.most = 1}), (Numbers{1}));
}

TEST(ChooseConformers, RefusesWhatCannotBe) {
  const Symmetric butane("butane.sdf");
  ShapeDistances shapes(butane.found);
  shapes.add(butane.model.positions);
  const std::vector<double> one{0.0}, none, bad{NAN};
  EXPECT_THROW(choose_conformers(shapes, one, {.most = 0}), OptionError);
  EXPECT_THROW(choose_conformers(shapes, one, {.rms = -1.0}), OptionError);
  EXPECT_THROW(choose_conformers(shapes, none, {}), InputError);
  EXPECT_THROW(choose_conformers(shapes, bad, {}), InputError);
}

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

}  // namespace pliant::choose_conformers_test
