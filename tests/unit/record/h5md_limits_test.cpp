// SPDX-License-Identifier: MIT
// What is written of frameworks is read back: limits, sterics, and parts that are saved.
#include "pliant/lab/examples/examples.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/record/h5md/saved_part.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::h5md_limits_test {

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
  FrameworkParts parts{.joint_count = 6};
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
  const H5mdReader reader = recorded(Framework({.joint_count = 5}), chain(5).positions);
  EXPECT_TRUE(reader.limits().empty());
  const auto names = reader.observables();
  EXPECT_EQ(std::ranges::count(names, "max_limit"), 0);
}

/// A square 0 1 2 3 with a limit across each way, joint 3 pinned, in two residues.
Framework square() {
  const AtomTable atoms{{"A", "B", "C", "D"},
                        {6, 7, 8, 6},
                        {0, 0, 1, 1},
                        {{"ONE", 1, ' ', "X"}, {"TWO", 2, ' ', "X"}},
                        {1, 2, 3, 4}};
  return Framework({.joint_count = 4,
                    .bars = {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                    .rest_lengths = {1.0, 1.5, 2.0, 2.5},
                    .masses = {1.0, 2.0, 4.0, 8.0},
                    .pinned = {3},
                    .atoms = std::make_shared<AtomTable>(atoms),
                    .limits = {{0, 2, 1.0, 3.0}, {1, 3, 1.0, 4.0}},
                    .sterics = test::spheres(4, 1.0)});
}

TEST(SavedPart, IsAFrameworkOfTheJointsAndOfWhatJoinsThem) {
  const SavedPart part(square(), std::vector<Joint>{1, 2, 3});
  const Framework& framework = part.framework();
  EXPECT_EQ(part.joints_of_whole(), 4u);
  ASSERT_EQ(framework.bar_count(), 2u);
  EXPECT_EQ(framework.bars()[0], (Bar{0, 1}));
  EXPECT_EQ(framework.bars()[1], (Bar{1, 2}));
  EXPECT_EQ(framework.rest_lengths()[1], 2.0);
  ASSERT_EQ(framework.limits().size(), 1u);
  EXPECT_EQ(framework.limits()[0], (Limit{0, 2, 1.0, 4.0}));
  EXPECT_EQ(framework.inverse_masses()[0], 0.5);
  EXPECT_TRUE(framework.is_pinned(2));
  EXPECT_EQ(framework.sterics(), nullptr);
}

TEST(SavedPart, KeepsNamesAndTheResiduesThatAreLeft) {
  const SavedPart part(square(), std::vector<Joint>{2, 3});
  EXPECT_EQ(part.framework().atoms()->residues[0].name, "TWO");
  EXPECT_EQ(part.framework().atoms()->label(1), "D(4)");
  EXPECT_EQ(part.framework().atoms()->residues.size(), 1u);
  EXPECT_EQ(part.framework().atoms()->serials, (std::vector<std::int64_t>{3, 4}));
}

TEST(SavedPart, TakesHeadersAndFrames) {
  SavedPart part(square(), std::vector<Joint>{1, 3});
  H5mdHeader header;
  header.bonds = {{0, 1, 0, 1}, {1, 3, 0, 2}};
  header.masses = {1, 2, 3, 4};
  EXPECT_EQ(part.header_of(header).bonds, (std::vector<RecordedBond>{{0, 1, 0, 2}}));
  EXPECT_EQ(part.header_of(header).masses, (std::vector<double>{2, 4}));
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
  const std::vector<std::uint8_t> off{0, 1};
  Frame frame;
  frame.step = 7;
  frame.positions = positions;
  frame.previous = positions;
  frame.limits_off = off;
  const Frame shown = part.shown(frame);
  EXPECT_EQ(shown.step, 7);
  ASSERT_EQ(shown.positions.size(), 2u);
  EXPECT_EQ(shown.positions[1], (Vec3{3, 3, 3}));
  EXPECT_TRUE(shown.previous.empty());
  ASSERT_EQ(shown.limits_off.size(), 1u);
  EXPECT_EQ(shown.limits_off[0], 1);
}

TEST(SavedPart, RefusesJointsOutOfOrderOrRange) {
  for (const std::vector<Joint>& joints :
       {std::vector<Joint>{}, {1, 1}, {2, 1}, {4}, {0, 1, 2, 3, 4}})
    EXPECT_THROW(SavedPart(square(), joints), OptionError);
}

}  // namespace pliant::h5md_limits_test
