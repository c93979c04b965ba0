// SPDX-License-Identifier: MIT
// Limits in H5MD files: what is written is read back.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "support/temp_directory.hpp"

namespace pliant {
namespace h5md_limits_test {

/// What is read of a recording of one frame, whose file is gone by then.
H5mdReader recorded(const Framework& framework, std::span<const Vec3> positions) {
  const test::TempDirectory directory;
  const auto path = directory / "limits.h5md";
  H5mdRecorder recorder(path, framework, {}, {});
  Frame frame;
  frame.positions = positions;
  frame.max_limit = 0.25;
  frame.max_overlap = 0.5;
  recorder.record(frame);
  recorder.close();
  return H5mdReader(path);
}

TEST(H5mdLimits, AreReadBackAsTheyWere) {
  const Example& example = find_example("tensegrity_prism");
  FrameworkParts parts;
  parts.joint_count = 6;
  parts.limits.assign(example.framework.limits().begin(), example.framework.limits().end());
  parts.limits[1].kind = LimitKind::hydrogen_bond;
  parts.limits[1].energy = -12.5;
  parts.limits[1].group = 3;
  const Framework framework(parts);
  const H5mdReader reader = recorded(framework, example.positions);
  EXPECT_EQ(reader.limits(), parts.limits);
  EXPECT_EQ(reader.schema(), 2);
  EXPECT_EQ(reader.observable("max_limit"), std::vector<double>{0.25});
  EXPECT_EQ(reader.observable("max_overlap"), std::vector<double>{0.5});
  const Framework again = reader.framework();
  EXPECT_TRUE(std::ranges::equal(again.limits(), framework.limits()));
}

/// A file says that its framework is one of the plane, and nothing if it is not.
TEST(H5mdLimits, LinkagesOfThePlaneAreReadBackAsSuch) {
  for (const bool planar : {true, false}) {
    const Framework framework(
        {.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {1.0}, .planar = planar});
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}};
    const H5mdReader reader = recorded(framework, positions);
    EXPECT_EQ(reader.framework().is_planar(), planar);
    EXPECT_TRUE(reader.parameters().empty());
  }
}

TEST(H5mdLimits, StericsAreReadBackAsTheyWere) {
  const Sterics sterics{.kind_count = 2,
                        .kinds = {0, 1, 0, 1, 1},
                        .least = {1.0, 1.25, 1.25, 0.0},
                        .own = {{4, 0, 0.1}, {1, 3, 0.0}},
                        .units = {0, 0, 7, no_unit, no_unit},
                        .excluded_bonds = 2,
                        .bonds = {{0, 4}}};
  for (const bool all : {true, false}) {
    auto written = std::make_shared<Sterics>(sterics);
    if (!all) written->own.clear(), written->units.clear(), written->bonds.clear();
    const Framework framework({.joint_count = 5, .sterics = written});
    const std::vector<Vec3> positions(5);
    const Framework again = recorded(framework, positions).framework();
    ASSERT_NE(again.sterics(), nullptr);
    const Sterics& read = *again.sterics();
    EXPECT_EQ(read.kind_count, written->kind_count);
    EXPECT_EQ(read.kinds, written->kinds);
    EXPECT_EQ(read.least, written->least);
    EXPECT_EQ(read.own, written->own);
    EXPECT_EQ(read.units, written->units);
    EXPECT_EQ(read.excluded_bonds, written->excluded_bonds);
    EXPECT_EQ(read.bonds, written->bonds);
  }
}

TEST(H5mdLimits, AFrameworkOfBarsAloneHasNoneOfThem) {
  const Example& example = find_example("chain_5_with_strut");
  FrameworkParts parts{.joint_count = 5};
  const H5mdReader reader = recorded(Framework(parts), example.positions);
  EXPECT_TRUE(reader.limits().empty());
  const auto names = reader.observables();
  EXPECT_EQ(std::ranges::count(names, "max_limit"), 0);
}

}  // namespace h5md_limits_test
}  // namespace pliant
