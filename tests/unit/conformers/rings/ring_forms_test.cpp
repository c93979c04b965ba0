// SPDX-License-Identifier: MIT
// Against the puckers of D. Cremer and J. A. Pople: z_k = q cos(phi + 4 pi k / N).
#include "pliant/conformers/rings/ring_forms.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace ring_forms_test {

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

}  // namespace ring_forms_test
}  // namespace pliant
