// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/saved_part.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"

namespace pliant {
namespace saved_part_test {

/// A square 0 1 2 3 with a limit across each way, joint 3 pinned, in two residues.
Framework square() {
  auto atoms = std::make_shared<AtomTable>();
  atoms->names = {"A", "B", "C", "D"};
  atoms->elements = {6, 7, 8, 6};
  atoms->serials = {1, 2, 3, 4};
  atoms->residue_of = {0, 0, 1, 1};
  atoms->residues = {{"ONE", 1, ' ', "X"}, {"TWO", 2, ' ', "X"}};
  Sterics sterics;
  sterics.kind_count = 1;
  sterics.kinds = {0, 0, 0, 0};
  sterics.least = {1.0};
  return Framework({.joint_count = 4,
                    .bars = {{0, 1}, {1, 2}, {2, 3}, {3, 0}},
                    .rest_lengths = {1.0, 1.5, 2.0, 2.5},
                    .masses = {1.0, 2.0, 4.0, 8.0},
                    .pinned = {3},
                    .atoms = std::move(atoms),
                    .limits = {{0, 2, 1.0, 3.0}, {1, 3, 1.0, 4.0}},
                    .sterics = std::make_shared<const Sterics>(std::move(sterics))});
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
  EXPECT_EQ(part.framework().atoms()->label(1), "X:TWO2:D");
  EXPECT_EQ(part.framework().atoms()->residues.size(), 1u);
  EXPECT_EQ(part.framework().atoms()->serials, (std::vector<std::int64_t>{3, 4}));
}

TEST(SavedPart, TakesHeadersAndFrames) {
  SavedPart part(square(), std::vector<Joint>{1, 3});
  const H5mdHeader header{.bonds = {{0, 1, 0, 1}, {1, 3, 0, 2}}, .masses = {1, 2, 3, 4}};
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

}  // namespace saved_part_test
}  // namespace pliant
