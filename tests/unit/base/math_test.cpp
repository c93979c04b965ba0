// SPDX-License-Identifier: MIT
#include <random>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/base/math/normal.hpp"
#include "support/test.hpp"

namespace pliant::math_test {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

TEST(Elementary, ExpIsThatOfTheLibraryToRounding) {
  for (double x = -690.0; x <= 690.0; x += 0.37)
    EXPECT_NEAR(exact_bits_exp(x) / std::exp(x), 1.0, 5e-16) << x;
  EXPECT_EQ(exact_bits_exp(0.0), 1.0);
  EXPECT_EQ(exact_bits_exp(-1e4), 0.0);
  EXPECT_TRUE(std::isinf(exact_bits_exp(1e4)));
}

TEST(Elementary, LogIsThatOfTheLibraryToRounding) {
  for (double x = 1e-300; x < 1e300; x *= 1.7)
    EXPECT_NEAR(exact_bits_log(x), std::log(x), 1e-15 * std::max(1.0, std::abs(std::log(x)))) << x;
  EXPECT_EQ(exact_bits_log(1.0), 0.0);
  for (double x : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isnan(exact_bits_log(x))) << x;
}

TEST(Elementary, CosIsThatOfTheLibraryToRounding) {
  for (double x = -100.0; x <= 100.0; x += 0.0137)
    EXPECT_NEAR(exact_bits_cos(x), std::cos(x), 5e-16) << x;
  EXPECT_EQ(exact_bits_cos(0.0), 1.0);
  for (double x : {101.0, -1e300, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isnan(exact_bits_cos(x))) << x;
}

TEST(Elementary, Atan2IsThatOfTheLibraryToRounding) {
  for (double angle = -3.14159; angle < 3.1416; angle += 1.7e-5) {
    const double y = 3.7 * std::sin(angle), x = 3.7 * std::cos(angle);
    EXPECT_NEAR(exact_bits_atan2(y, x), std::atan2(y, x), 1e-15) << angle;
  }
  for (double small : {1e-300, 1e-20, 1e-9, 1e-3})
    EXPECT_NEAR(exact_bits_atan2(small, 2.0) / std::atan2(small, 2.0), 1.0, 1e-15) << small;
  for (double y : {-2.0, 0.0, 2.0})
    for (double x : {-2.0, 0.0, 2.0}) EXPECT_EQ(exact_bits_atan2(y, x), std::atan2(y, x));
}

TEST(Elementary, AcosIsThatOfTheLibraryToRounding) {
  for (int k = -100000; k <= 100000; k += 7)
    EXPECT_NEAR(exact_bits_acos(k * 1e-5), std::acos(k * 1e-5), 1e-15) << k;
  EXPECT_EQ(exact_bits_acos(1.0), 0.0);
  EXPECT_EQ(exact_bits_acos(-1.0), std::acos(-1.0));
  EXPECT_NEAR(exact_bits_acos(1.0 - 1e-15) / std::acos(1.0 - 1e-15), 1.0, 1e-14);
  EXPECT_TRUE(std::isnan(exact_bits_acos(1.0000001)));
}

/// Moments of the normal distribution: 0, 1, 0, 3; the bounds are five standard errors.
TEST(Normal, HasTheMomentsOfTheNormalDistribution) {
  std::vector<double> numbers(200001);
  RandomSequence draws({7, Domain::amplitude, 0, 0, 0});
  fill_normal(draws, numbers);
  const auto count = double(numbers.size());
  const double expected[] = {0.0, 1.0, 0.0, 3.0}, variance[] = {1.0, 2.0, 15.0, 96.0};
  for (int power = 1; power <= 4; ++power) {
    double sum = 0.0;
    for (double x : numbers) sum += std::pow(x, power);
    EXPECT_NEAR(sum / count, expected[power - 1], 5.0 * std::sqrt(variance[power - 1] / count));
  }
}

Pairs pairs_by_cells(const std::vector<Vec3>& points, double cutoff) {
  Pairs pairs;
  CellList(points, cutoff).for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
    EXPECT_LT(i, j);
    EXPECT_EQ(squared, norm_squared(points[j] - points[i]));
    pairs.emplace_back(i, j);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Pairs pairs_by_brute_force(const std::vector<Vec3>& points, double cutoff) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (std::uint32_t j = i + 1; j < points.size(); ++j)
      if (norm_squared(points[j] - points[i]) <= cutoff * cutoff) pairs.emplace_back(i, j);
  return pairs;
}

std::vector<Vec3> random_points(std::size_t count, Vec3 extent, Vec3 offset, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(offset +
                     Vec3{extent.x * uniform(), extent.y * uniform(), extent.z * uniform()});
  return points;
}

void expect_same_pairs(const std::vector<Vec3>& points, double cutoff) {
  const Pairs expected = pairs_by_brute_force(points, cutoff);
  EXPECT_EQ(pairs_by_cells(points, cutoff), expected);
}

TEST(CellList, FindsWhatBruteForceFinds) {
  unsigned seed = 1;
  for (Vec3 extent : {Vec3{20, 20, 20}, Vec3{200, 3, 3}, Vec3{3, 200, 0}, Vec3{0, 0, 150}})
    for (Vec3 offset : {Vec3{}, Vec3{-1000, 77, 1e5}, Vec3{1e8, -1e8, 0}})
      for (double cutoff : {0.7, 2.5, 40.0})
        expect_same_pairs(random_points(300, extent, offset, seed++), cutoff);
}

TEST(CellList, FindsPairsAroundPlaceholdersAndFarOutliers) {
  std::vector<Vec3> points = random_points(200, {15, 15, 15}, {}, 7);
  points[3] = points[90] = {9999.999, 9999.999, 9999.999};
  points[20] = {1e12, -1e12, 3.0};
  points[21] = {1e12 + 1.0, -1e12, 3.0};
  points[40] = {1e290, 1e290, -1e290};
  points[41] = {-1e290, 0.0, 0.0};
  expect_same_pairs(points, 2.5);
}

TEST(CellList, KeepsNeighboursWhenAnAxisIsTooWideToCount) {
  std::vector<Vec3> points;
  for (int k = 0; k < 300; ++k) {
    const double site = 1e11 * (k / 3);
    points.push_back({site + 2.0 * (k % 3), -site, 0.5 * k});
  }
  expect_same_pairs(points, 2.5);
  EXPECT_EQ(pairs_by_cells(points, 2.5).size(), 200U);
}

TEST(CellList, FindsPairsExactlyAtTheCutoff) {
  std::vector<Vec3> points;
  for (int k = 0; k < 1000; ++k) points.push_back({2.5 * k, 0.0, 0.0});
  EXPECT_EQ(pairs_by_cells(points, 2.5).size(), 999U);
}

TEST(CellList, TakesNoPointsOnePointAndCoincidentPoints) {
  EXPECT_TRUE(pairs_by_cells({}, 1.0).empty());
  EXPECT_TRUE(pairs_by_cells({{1, 2, 3}}, 1.0).empty());
  EXPECT_EQ(pairs_by_cells(std::vector<Vec3>(4, Vec3{1, 2, 3}), 1.0).size(), 6U);
}

TEST(CellList, NamesThePointsOfCrowdedCells) {
  std::vector<Vec3> points = random_points(50, {100, 100, 100}, {}, 5);
  for (std::size_t i : {7U, 3U, 31U, 40U}) points[i] = {50.0, 50.0, 50.0};
  const CellList cells(points, 0.5);
  EXPECT_EQ(cells.points_in_cells_above(3), (std::vector<std::uint32_t>{3, 7, 31, 40}));
  EXPECT_TRUE(cells.points_in_cells_above(4).empty());
}

TEST(CellList, GivesPairsInTheSameOrderWhereverThePointsLie) {
  const std::vector<Vec3> points = random_points(400, {16, 16, 16}, {}, 11);
  std::vector<Vec3> moved(points);
  for (Vec3& p : moved) p += Vec3{1024.0, -2048.0, 512.0};
  Pairs here, there;
  CellList(points, 2.0).for_each_pair([&](auto i, auto j, double) { here.emplace_back(i, j); });
  CellList(moved, 2.0).for_each_pair([&](auto i, auto j, double) { there.emplace_back(i, j); });
  EXPECT_EQ(here, there);
}

}  // namespace pliant::math_test
