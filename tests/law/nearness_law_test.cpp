// SPDX-License-Identifier: MIT
// What is resolved stays near: after a push of size e no joint ends further from where the push
// left it than a constant times e, however long the framework. The page on methods has the
// constants.
#include <algorithm>
#include <set>

#include "law/technique_cases.hpp"

namespace pliant {
namespace nearness_law_test {

constexpr double most_growth = 20.0;

class NearnessLaw : public test::TechniqueLaw {};

double farthest(std::span<const Vec3> a, std::span<const Vec3> b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, distance(a[k], b[k]));
  return most;
}

/// How much further than `size` some joint moves where each of `joints` is pushed by it.
double growth(const Framework& framework, std::span<const Vec3> positions, const char* technique,
              double size, Joint root, bool all) {
  std::vector<Vec3> x(positions.begin(), positions.end());
  for (Joint joint = all ? 0 : root; joint < (all ? x.size() : root + 1); ++joint)
    if (!framework.is_pinned(joint))
      x[joint] +=
          size * framework.random_direction(RandomSequence({7, Domain::force, 0, 0, joint}));
  const std::vector<Vec3> pushed = x;
  Resolver(framework, {technique}).resolve(x, root, 0, positions);
  return farthest(x, pushed) / size;
}

TEST_P(NearnessLaw, NoJointMovesMuchFurtherThanThePush) {
  const std::string technique(GetParam().name);
  each_example([&](const Example& example) {
    if (!example.facts.whole || example.positions.empty()) return;
    const double bar = test::shortest_bar(example.framework);
    for (double size : {0.001, 0.01, 0.1})
      for (Joint root : {Joint{0}, static_cast<Joint>(example.positions.size() / 2)})
        for (bool all : {false, true})
          EXPECT_LE(growth(example.framework, example.positions, technique.c_str(), size * bar,
                           root, all),
                    most_growth)
              << size << (all ? ", all joints" : ", one joint") << ", root " << root;
  });
}

PLIANT_FOR_ALL_TECHNIQUES(NearnessLaw);

/// A zigzag whose angles are held, and whose torsions are free: a chain without side groups, on
/// which an error of one unit is a swing of the next.
Sketch zigzag(std::size_t joints) { return with_angles(shaken(chain(joints), 0.2)); }

TEST(Nearness, HoldsOnLongThinChains) {
  for (std::size_t joints : {100, 1000, 10'000}) {
    const Sketch sketch = zigzag(joints);
    const Framework framework = framework_of(sketch);
    for (const char* technique : {"auto", "units"})
      for (double size : {0.001, 0.01, 0.1})
        for (bool all : {false, true})
          EXPECT_LE(growth(framework, sketch.positions, technique, size,
                           static_cast<Joint>(joints / 3), all),
                    most_growth)
              << technique << " " << joints << " " << size << (all ? " all" : " one");
  }
}

}  // namespace nearness_law_test
}  // namespace pliant
