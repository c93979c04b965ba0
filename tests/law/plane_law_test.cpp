// SPDX-License-Identifier: MIT
// Linkages of the plane stay in it, whatever pushes them within it and whatever resolves them.
#include "law/technique_cases.hpp"

namespace pliant {
namespace plane_law_test {

class PlaneLaw : public test::TechniqueLaw {};

Framework planar(const Framework& framework) {
  FrameworkParts parts = test::parts_of(framework);
  parts.planar = true;
  return Framework(std::move(parts));
}

/// Each joint moved by `size` in a direction of the plane.
std::vector<Vec3> pushed(const Framework& framework, std::span<const Vec3> positions, double size) {
  std::vector<Vec3> x(positions.begin(), positions.end());
  for (Joint joint = 0; joint < x.size(); ++joint)
    if (!framework.is_pinned(joint))
      x[joint] +=
          size * framework.random_direction(RandomSequence({1, Domain::force, 0, 0, joint}));
  return x;
}

bool is_flat(std::span<const Vec3> positions) {
  for (const Vec3& x : positions)
    if (x.z != 0.0) return false;
  return true;
}

TEST_P(PlaneLaw, FrameworksOfThePlaneStayInIt) {
  std::size_t seen = 0;
  each_case([&](const Example& example, const Technique& technique) {
    if (!is_flat(example.positions) || !example.framework.has_bars_only()) return;
    const Framework framework = planar(example.framework);
    ++seen;
    for (double size : {1e-3, 0.05, 1.0}) {
      std::vector<Vec3> x = pushed(framework, example.positions, size);
      resolve(framework, technique, x, {{}, 50});
      EXPECT_TRUE(is_flat(x)) << "pushed by " << size;
    }
  });
  EXPECT_GT(seen, 0u);
}

PLIANT_FOR_ALL_TECHNIQUES(PlaneLaw);

/// Two triangles with three bars between them, parallel ones and such as meet in a point.
TEST(Plane, PrismsAreMadeWholeByWhateverAutoTakes) {
  for (const Example& example : examples()) {
    if (!example.name.starts_with("prism_2D")) continue;
    const Framework framework = planar(example.framework);
    for (double size : {1e-3, 0.05}) {
      std::vector<Vec3> x = pushed(framework, example.positions, size);
      EXPECT_TRUE(resolve(framework, {"auto"}, x).converged()) << example.name << " " << size;
    }
  }
}

}  // namespace plane_law_test
}  // namespace pliant
