// SPDX-License-Identifier: MIT
// Curves of a few atoms in closed form.
#include "pliant/fit/saxs/partial_profiles.hpp"

#include "pliant/fit/saxs/exposure.hpp"
#include "support/test.hpp"

namespace pliant::partial_profiles_test {

constexpr ScatteringGroup methyl{6, 3}, oxygen{8, 0};
const std::vector<double> q{0.0, 0.1, 0.3, 0.5};

double at(const std::vector<double>& profiles, Partial partial, std::size_t k) {
  return profiles[static_cast<std::size_t>(partial) * q.size() + k];
}

TEST(PartialProfiles, TwoGroupsInterfere) {
  const std::vector<ScatteringGroup> groups{oxygen, methyl};
  const std::vector<Vec3> positions{{1, 2, 3}, {1, 2, 53.025}};
  const std::vector<double> found = PartialProfiles(groups, q, 60.0).of(positions);
  for (std::size_t k = 0; k < q.size(); ++k) {
    const double x = q[k] * 50.025, wave = k == 0 ? 1.0 : std::sin(x) / x;
    const double a = form_factor(oxygen, q[k]), b = form_factor(methyl, q[k]);
    const double c = displaced_form_factor(9.13, q[k]), d = displaced_form_factor(31.89, q[k]);
    const double w = water_form_factor(q[k]);
    EXPECT_NEAR(at(found, Partial::vv, k), a * a + b * b + 2 * a * b * wave, 1e-3);
    EXPECT_NEAR(at(found, Partial::vd, k), a * c + b * d + (a * d + b * c) * wave, 1e-3);
    EXPECT_NEAR(at(found, Partial::dd, k), c * c + d * d + 2 * c * d * wave, 1e-3);
    EXPECT_NEAR(at(found, Partial::vw, k), (a + b) * w * (1 + wave), 1e-3);
    EXPECT_NEAR(at(found, Partial::dw, k), (c + d) * w * (1 + wave), 1e-3);
    EXPECT_NEAR(at(found, Partial::ww, k), 2 * w * w * (1 + wave), 1e-3);
  }
}

TEST(PartialProfiles, NoGroupsAndMoleculesWithoutEnd) {
  for (const double value : PartialProfiles({}, q, 0.0).of({})) EXPECT_EQ(value, 0.0);
  const std::vector<ScatteringGroup> one{oxygen};
  EXPECT_ERROR(InputError, "positions: expected distances of at most 20000 Angstrom, found 100000",
               PartialProfiles(one, q, 1e5));
}

TEST(Exposures, NeighboursCoverPoints) {
  const std::vector<ScatteringGroup> groups{methyl, methyl, oxygen};
  const std::vector<Vec3> positions{{0, 0, 0}, {0, 0, 3.7}, {0, 0, 30}};
  const std::vector<std::uint32_t> found = exposures(groups, positions);
  EXPECT_EQ(found[2], exposure_points);
  EXPECT_NEAR(found[0], 0.75 * exposure_points, 1.0);
  EXPECT_NEAR(found[1], 0.75 * exposure_points, 1.0);
}

}  // namespace pliant::partial_profiles_test
