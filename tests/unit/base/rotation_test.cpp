// SPDX-License-Identifier: MIT
#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/math/superposition.hpp"
#include "pliant/base/random.hpp"
#include "support/test.hpp"

namespace pliant::rotation_test {

TEST(AxisAngle, IsThatOfTheRotation) {
  const Vec3 axis{2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0};
  for (const double angle : {0.01, 1.0, 2.0, 3.1}) {
    const AxisAngle found = axis_angle(rotation_by(axis, angle));
    EXPECT_NEAR(found.angle, angle, 1e-12);
    EXPECT_LT(distance(found.axis, axis), 1e-11);
  }
}

TEST(AxisAngle, OfHalfATurnIsPi) {
  const Vec3 axis{2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0};
  const Rotation half{2.0 * axis.x * axis - Vec3{1, 0, 0}, 2.0 * axis.y * axis - Vec3{0, 1, 0},
                      2.0 * axis.z * axis - Vec3{0, 0, 1}};
  const AxisAngle found = axis_angle(half);
  EXPECT_NEAR(found.angle, 3.14159265358979, 1e-7);
  EXPECT_NEAR(std::abs(dot(found.axis, axis)), 1.0, 1e-12);
}

TEST(AxisAngle, OfNoRotationIsZero) { EXPECT_EQ(axis_angle(Rotation{}).angle, 0.0); }

TEST(RotationBy, TurnsByTheAngle) {
  for (const double angle : {0.5, 3.0, 4.0, 6.0}) {
    const Vec3 x = rotation_by({0, 0, 1}, angle)({1, 0, 5});
    EXPECT_LT(distance(x, {std::cos(angle), std::sin(angle), 5}), 1e-12) << angle;
    EXPECT_LT(distance(inverse(rotation_by({0, 0, 1}, angle))(x), {1, 0, 5}), 1e-12) << angle;
  }
}

std::vector<Vec3> cloud(std::uint64_t seed, std::size_t count = 5) {
  RandomSequence draws({seed, Domain::generate});
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back(draws.uniform() * draws.direction());
  return points;
}

/// A third of a turn about (1, 1, 1), then a quarter about z.
Vec3 turned(Vec3 p) { return {-p.x, p.z, p.y}; }

TEST(FindEigenvectors, OfAMatrixWithKnownOnes) {
  // Eigenvalues 1, 2, 4 with eigenvectors (1, -1, 0) / sqrt 2, (1, 1, -2) / sqrt 6, (1, 1, 1) / ...
  std::array<double, 9> a{}, v{};
  const Vec3 axes[] = {{1, -1, 0}, {1, 1, -2}, {1, 1, 1}};
  const double values[] = {1, 2, 4};
  for (int k = 0; k < 3; ++k) {
    const double n2 = norm_squared(axes[k]);
    const double u[] = {axes[k].x, axes[k].y, axes[k].z};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) a[3 * i + j] += values[k] * u[i] * u[j] / n2;
  }
  find_eigenvectors(a, v, 3);
  std::array<double, 3> found{a[0], a[4], a[8]};
  std::sort(found.begin(), found.end());
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], values[k], 1e-14);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      EXPECT_NEAR(v[i] * v[j] + v[3 + i] * v[3 + j] + v[6 + i] * v[6 + j], i == j, 1e-15);
}

TEST(RotationFit, FindsTheRotationOfTurnedPoints) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RotationFit fit;
    const auto points = cloud(seed, 3 + seed % 4);
    for (Vec3 p : points) fit.add(p, turned(p), 1.0 + double(seed));
    Rotation found;
    ASSERT_EQ(fit.solve(false, found), RotationFit::Fit::fitted);
    for (Vec3 p : points) EXPECT_LT(distance(found(p), turned(p)), 1e-14);
  }
}

/// The mirror image of a shape is fitted as well as a rotation can, and no better; where it is
/// allowed the fit says so.
TEST(RotationFit, NeverReflectsUnlessAllowed) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RotationFit fit;
    const auto points = cloud(seed);
    for (Vec3 p : points) fit.add(p, -turned(p), 1.0);
    Rotation found;
    ASSERT_EQ(fit.solve(false, found), RotationFit::Fit::fitted);
    EXPECT_NEAR(dot(found.x, cross(found.y, found.z)), 1.0, 1e-14);
    ASSERT_EQ(fit.solve(true, found), RotationFit::Fit::mirrored);
    for (Vec3 p : points) EXPECT_LT(distance(-found(p), -turned(p)), 1e-14);
  }
}

/// No small rotation away from the one found fits better.
TEST(RotationFit, IsTheBestOfAllRotationsNearby) {
  RandomSequence draws({7, Domain::generate});
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto shape = cloud(seed), target = cloud(seed + 100);
    RotationFit fit;
    for (std::size_t k = 0; k < shape.size(); ++k) fit.add(shape[k], target[k], 1.0 + double(k));
    Rotation best;
    ASSERT_EQ(fit.solve(false, best), RotationFit::Fit::fitted);
    const auto badness = [&](auto turn) {
      double sum = 0.0;
      for (std::size_t k = 0; k < shape.size(); ++k)
        sum += (1.0 + double(k)) * norm_squared(target[k] - turn(best(shape[k])));
      return sum;
    };
    const double least = badness([](Vec3 p) { return p; });
    for (int k = 0; k < 100; ++k) {
      const Vec3 n = draws.direction();
      const double c = 0.8, s = 0.6;  // Rodrigues
      EXPECT_GE(badness([&](Vec3 p) { return c * p + s * cross(n, p) + (1 - c) * dot(n, p) * n; }),
                least);
    }
  }
}

TEST(RotationFit, TellsWhatHasNoFit) {
  Rotation found;
  EXPECT_EQ(RotationFit().solve(false, found), RotationFit::Fit::undefined);
  RotationFit nowhere;
  nowhere.add({1, 0, 0}, {std::nan(""), 0, 0}, 1.0);
  EXPECT_EQ(nowhere.solve(false, found), RotationFit::Fit::not_finite);
}

TEST(AxisBasis, IsRightHandedAndOrthonormalForEveryAxis) {
  RandomSequence draws({3, Domain::generate});
  std::vector<Vec3> axes{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}};
  for (int k = 0; k < 200; ++k) axes.push_back(draws.direction());
  for (Vec3 axis : axes) {
    const AxisBasis basis(axis);
    EXPECT_NEAR(norm(basis.e1), 1.0, 4e-16);
    EXPECT_NEAR(norm(basis.e2), 1.0, 4e-16);
    EXPECT_LT(distance(cross(basis.e1, basis.e2), axis), 1e-15);
  }
}

TEST(TorsionFit, FindsTheTurnAndTheMirrorImage) {
  const double c = 0.6, s = 0.8;
  TorsionFit fit, mirrored;
  for (Vec3 p : cloud(5)) {
    fit.add(p.x, p.y, c * p.x - s * p.y, s * p.x + c * p.y, 1.0);
    mirrored.add(p.x, -p.y, c * p.x - s * p.y, s * p.x + c * p.y, 1.0);
  }
  for (const TorsionFit::Turn turn : {fit.solve(false), fit.solve(true), mirrored.solve(true)}) {
    EXPECT_NEAR(turn.cosine, c, 1e-15);
    EXPECT_NEAR(turn.sine, s, 1e-15);
    EXPECT_GT(turn.strength, 0.0);
  }
  EXPECT_EQ(fit.solve(true).v_sign, 1.0);
  EXPECT_EQ(mirrored.solve(true).v_sign, -1.0);
  EXPECT_LT(mirrored.solve(false).strength, mirrored.solve(true).strength);
}

std::vector<Vec3> tripod() { return {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {0, 0, 1}, {1, 1, 1}}; }

std::vector<Vec3> moved(std::vector<Vec3> points, double angle, Vec3 shift) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec3& p : points) p = Vec3{c * p.x - s * p.y, s * p.x + c * p.y, p.z} + shift;
  return points;
}

TEST(Superposition, TakesBackARigidMotion) {
  const std::vector<Vec3> goal = tripod(), points = moved(goal, 1.1, {4, -5, 6});
  const RigidMotion motion = superposition(points, goal);
  for (std::size_t k = 0; k < goal.size(); ++k) EXPECT_LT(norm(motion(points[k]) - goal[k]), 1e-12);
}

TEST(Superposition, NeverReflects) {
  std::vector<Vec3> mirrored = tripod();
  for (Vec3& p : mirrored) p.z = -p.z;
  const Rotation r = superposition(mirrored, tripod()).rotation;
  EXPECT_NEAR(dot(r.x, cross(r.y, r.z)), 1.0, 1e-12);
}

TEST(Superposition, TwoPointsAreShiftedOnly) {
  const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}}, goal{{1, 1, 0}, {1, 3, 0}};
  const RigidMotion motion = superposition(points, goal);
  EXPECT_EQ(motion.rotation.x, (Vec3{1, 0, 0}));
  EXPECT_EQ(motion({0, 0, 0}), (Vec3{0, 2, 0}));
}

TEST(Superposition, OnlyWhatMovesFluctuates) {
  std::vector<std::vector<Vec3>> frames;
  std::vector<Vec3> ring;  // so many points that one of them does not turn the fit
  for (int k = 0; k < 400; ++k) ring.push_back({std::cos(0.1 * k), std::sin(0.1 * k), 0.01 * k});
  for (int k = 0; k < 10; ++k) {
    std::vector<Vec3> frame = ring;
    frame[7] += Vec3{0, 0, k % 2 == 0 ? 0.01 : -0.01};
    frames.push_back(moved(frame, 0.3 * k, {1.0 * k, 2, 3}));
  }
  const std::vector<double> found = superposed_fluctuations(frames);
  EXPECT_NEAR(found[7], 0.01, 2e-4);
  EXPECT_LT(found[8], 3e-4);
  EXPECT_TRUE(superposed_fluctuations({}).empty());
}

}  // namespace pliant::rotation_test
