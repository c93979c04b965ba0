// SPDX-License-Identifier: MIT
// Every row of techniques() on every example with every weighting: what the laws iterate over.
#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/guide.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "support/frameworks.hpp"

namespace pliant {

/// How GoogleTest shows a row.
inline void PrintTo(const TechniqueEntry& row, std::ostream* out) { *out << row.name; }

}  // namespace pliant

namespace pliant::test {

inline std::string technique_name(const testing::TestParamInfo<TechniqueEntry>& row) {
  return std::string(row.param.name);
}

/// A suite that runs once for each row of the table.
class TechniqueLaw : public testing::TestWithParam<TechniqueEntry> {
 protected:
  /// The technique of this row with each weighting, if it has any, with and without masses.
  static std::vector<Technique> variants() {
    std::vector<Technique> all;
    for (double weighting : {0.5, 0.0, 0.3, 0.75, 1.0})
      for (bool mass_weighted : {false, true})
        if (GetParam().has_weighting || weighting == 0.5)
          all.push_back({std::string(GetParam().name), weighting, mass_weighted});
    return all;
  }

  static Technique plain(double weighting = 0.5) {
    return {std::string(GetParam().name), weighting, false};
  }

  static bool applies_to(const Example& example) {
    if (!example.framework.has_bars_only() && !GetParam().knows_limits) return false;
    return !GetParam().forests_only || example.facts.cycles == 0;
  }

  /// Calls `look(example)` for each example that the technique may resolve.
  template <class Look>
  static void each_example(Look look) {
    for (const Example& example : examples()) {
      if (!applies_to(example)) continue;
      SCOPED_TRACE(example.name);
      look(example);
    }
  }

  /// Calls `look(example, technique)` for each example and variant.
  template <class Look>
  static void each_case(Look look) {
    each_example([&](const Example& example) {
      for (const Technique& technique : variants()) {
        SCOPED_TRACE("weighting " + std::to_string(technique.weighting) +
                     (technique.mass_weighted ? ", mass weighted" : ""));
        look(example, technique);
      }
    });
  }
};

/// A small break: a twentieth of the shortest bar.
inline double small_break(const Framework& framework) { return 0.05 * shortest_bar(framework); }

/// Rocks all joints, pulls the first, and asks for a distance of first and last.
inline Guide guide_of(const Framework& framework) {
  Guide guide;
  const auto last = static_cast<Joint>(framework.joint_count() - 1);
  for (Joint joint = 0; joint <= last; ++joint)
    guide.rock.push_back(small_break(framework) * Vec3{3.0, double(joint % 3), -1.0});
  guide.pulls = {{{0}, {5.0, 1.0, 2.0}}};
  guide.pairs = {{{0}, {last}, 3.0, 4.0}};
  guide.period = 7;
  return guide;
}

}  // namespace pliant::test

#define PLIANT_FOR_ALL_TECHNIQUES(suite)                                                \
  INSTANTIATE_TEST_SUITE_P(Table, suite,                                                \
                           testing::ValuesIn(techniques().begin(), techniques().end()), \
                           ::pliant::test::technique_name)
