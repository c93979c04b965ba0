// SPDX-License-Identifier: MIT
#include "pliant/framework/edits.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"

namespace pliant::edits_test {

/// A hexagon with two contacts: one of two limits, one of a limit alone.
Framework hexagon() {
  FrameworkParts parts = framework_of(ring(6)).parts();
  parts.drawn = ring(6).positions;
  parts.limits = {{0, 3, 0.0, 2.5, LimitKind::hydrogen_bond, 0.0, 0},
                  {0, 2, 0.0, 2.5, LimitKind::hydrogen_bond, 0.0, 0},
                  {1, 4, 0.0, 2.5, LimitKind::hydrophobic, 0.0, 1}};
  return Framework(parts);
}

Framework after(const std::vector<FrameworkEdit>& edits) {
  return edited(hexagon(), edits, ring(6).positions).framework;
}

std::string refusal(const std::vector<FrameworkEdit>& edits) {
  return test::error_text<OptionError>([&] { after(edits); });
}

TEST(Edits, CutABarOrAllOfAContact) {
  const Framework bar = after({{EditKind::cut, 1, 0}});
  EXPECT_EQ(bar.bar_count(), 5u);
  EXPECT_EQ(bar.limits().size(), 3u);
  EXPECT_FALSE(bar.drawn().empty());
  const Framework contact = after({{EditKind::cut, 3, 0}});
  EXPECT_EQ(contact.bar_count(), 6u);
  ASSERT_EQ(contact.limits().size(), 1u);
  EXPECT_EQ(contact.limits()[0], hexagon().limits()[2]);
}

TEST(Edits, AddABarInPlaceOfWhatJoinsThePair) {
  const Framework spanned = after({{EditKind::bar, 4, 1, 2.2}});
  EXPECT_EQ(spanned.bars().back(), (Bar{4, 1}));
  EXPECT_EQ(spanned.rest_lengths().back(), 2.2);
  EXPECT_EQ(spanned.limits().size(), 2u);
  EXPECT_TRUE(spanned.drawn().empty()) << "nowhere are all bars whole";
  const Framework longer = after({{EditKind::bar, 0, 1, 1.25}, {EditKind::bar, 0, 1, 1.5}});
  EXPECT_EQ(longer.bar_count(), 6u);
  EXPECT_EQ(longer.rest_lengths().back(), 1.5);
  const Framework other =
      after({{EditKind::bar, 0, 4, distance(ring(6).positions[0], ring(6).positions[4])}});
  EXPECT_FALSE(other.drawn().empty());
}

TEST(Edits, RestoreWhatWasThereAtTheStart) {
  const Framework start = hexagon();
  for (const FrameworkEdit edit :
       {FrameworkEdit{EditKind::cut, 0, 1}, FrameworkEdit{EditKind::cut, 0, 3},
        FrameworkEdit{EditKind::bar, 0, 3, 2.0}, FrameworkEdit{EditKind::bar, 1, 5, 2.0}}) {
    const Framework back = after({edit, {EditKind::restore, edit.b, edit.a}});
    EXPECT_TRUE(std::ranges::equal(back.bars(), start.bars()));
    EXPECT_TRUE(std::ranges::equal(back.rest_lengths(), start.rest_lengths()));
    EXPECT_TRUE(std::ranges::equal(back.limits(), start.limits()));
    EXPECT_EQ(back.drawn().size(), 6u);
  }
}

TEST(Edits, LetWhatABarJoinsComeNear) {
  FrameworkParts parts = framework_of(ring(6)).parts();
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 1;
  sterics->least = {1.9};
  sterics->kinds.assign(6, 0);
  sterics->excluded_bonds = 2;
  sterics->own = {{0, 3, 1.8}};
  parts.sterics = sterics;
  const Framework near =
      edited(Framework(parts), {{EditKind::bar, 3, 0, 1.2}}, ring(6).positions).framework;
  ASSERT_EQ(near.sterics()->own.size(), 1u);
  EXPECT_EQ(near.sterics()->own[0], (OwnDistance{0, 3, 0.0}));
}

TEST(Edits, AreRefusedWhereTheyChangeNothing) {
  EXPECT_EQ(refusal({{EditKind::cut, 0, 6}}), "cut: joint 6 of 6 does not exist");
  EXPECT_EQ(refusal({{EditKind::bar, 2, 2, 1.0}}), "bar 2 - 2, 1 Angstrom: expected two joints");
  EXPECT_EQ(refusal({{EditKind::cut, 1, 5}}), "cut 1 - 5: neither a bar nor a contact joins them");
  EXPECT_EQ(refusal({{EditKind::cut, 0, 1}, {EditKind::cut, 0, 1}}),
            "cut 0 - 1: neither a bar nor a contact joins them");
  EXPECT_EQ(refusal({{EditKind::restore, 0, 1}}), "restore 0 - 1: is as it was at the start");
  EXPECT_EQ(refusal({{EditKind::bar, 1, 5, 0.0}}),
            "bar 1 - 5, 0 Angstrom: expected a length from 1e-150 to 1e150 Angstrom");
  EXPECT_EQ(refusal({{EditKind::bar, 1, 5, 2.0}, {EditKind::bar, 5, 1, 2.0}}),
            "bar 5 - 1, 2 Angstrom: is there already");
}

}  // namespace pliant::edits_test
