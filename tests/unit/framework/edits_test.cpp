// SPDX-License-Identifier: MIT
#include "pliant/framework/edits.hpp"

#include "pliant/base/random.hpp"
#include "pliant/framework/torsion_preferences.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

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
  auto sterics = test::spheres(6, 1.9, 2);
  sterics->own = {{0, 3, 1.8}};
  parts.sterics = sterics;
  const Framework near =
      edited(Framework(parts), {{EditKind::bar, 3, 0, 1.2}}, ring(6).positions).framework;
  ASSERT_EQ(near.sterics()->own.size(), 1u);
  EXPECT_EQ(near.sterics()->own[0], (OwnDistance{0, 3, 0.0}));
}

TEST(Edits, AreRefusedWhereTheyChangeNothing) {
  const FrameworkEdit cut_bar{EditKind::cut, 0, 1};
  const std::pair<const char*, std::vector<FrameworkEdit>> cases[] = {
      {"cut: joint 6 of 6 does not exist", {{EditKind::cut, 0, 6}}},
      {"bar 2 - 2, 1 Angstrom: expected two joints", {{EditKind::bar, 2, 2, 1.0}}},
      {"cut 1 - 5: neither a bar nor a contact joins them", {{EditKind::cut, 1, 5}}},
      {"cut 0 - 1: neither a bar nor a contact joins them", {cut_bar, cut_bar}},
      {"restore 0 - 1: is as it was at the start", {{EditKind::restore, 0, 1}}},
      {"bar 1 - 5, 0 Angstrom: expected a length from 1e-150 to 1e150 Angstrom",
       {{EditKind::bar, 1, 5, 0.0}}},
      {"bar 5 - 1, 2 Angstrom: is there already",
       {{EditKind::bar, 1, 5, 2.0}, {EditKind::bar, 5, 1, 2.0}}},
  };
  for (const auto& [text, edits] : cases) EXPECT_ERROR(OptionError, text, after(edits));
}

constexpr double degrees = std::numbers::pi / 180.0;

/// Blondel and Karplus, J. Comput. Chem. 17 (1996) 1132, with the C library's arctan.
double by_arctan(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 f = a - b, g = b - c, h = d - c;
  const Vec3 one = cross(f, g), other = cross(h, g);
  return std::atan2(dot(cross(other, one), g) / norm(g), dot(one, other));
}

TEST(TorsionPreferences, TorsionIsThatOfArctan) {
  RandomSequence draws({7, Domain::displacement, 0, 0, 0});
  for (int k = 0; k < 1000; ++k) {
    const Vec3 a = draws.direction(), b = draws.direction(), c = draws.direction(),
               d = draws.direction();
    EXPECT_NEAR(torsion_angle(a, b, c, d), by_arctan(a, b, c, d), 1e-12);
  }
}

TEST(TorsionPreferences, TorsionOfALineIsZero) {
  EXPECT_EQ(torsion_angle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}), 0.0);
}

TEST(TorsionPreferences, OffStaggeredIsTheNearestOfThree) {
  for (int turn = -180; turn <= 180; ++turn) {
    double nearest = 360.0;
    for (const double well : {-180.0, -60.0, 60.0, 180.0})
      if (std::abs(turn - well) < std::abs(nearest)) nearest = turn - well;
    EXPECT_NEAR(std::abs(off_staggered(turn * degrees)), std::abs(nearest) * degrees, 1e-12)
        << turn;
    EXPECT_LE(std::abs(off_staggered(turn * degrees)), 60.0 * degrees + 1e-12);
  }
  EXPECT_NEAR(off_staggered(70.0 * degrees), 10.0 * degrees, 1e-12);
  EXPECT_NEAR(off_staggered(-170.0 * degrees), 10.0 * degrees, 1e-12);
}

TEST(TorsionPreferences, UsualPlacesOfTheBackboneAreInside) {
  for (const auto& [phi, psi] : {std::pair{-63.0, -43.0},
                                 {-120.0, 130.0},
                                 {-75.0, 145.0},
                                 {-140.0, 165.0},
                                 {-90.0, 0.0},
                                 {57.0, 40.0},
                                 {-120.0, -175.0}})
    EXPECT_LT(backbone_reach(phi * degrees, psi * degrees), 1.0) << phi << ", " << psi;
  for (const auto& [phi, psi] : {std::pair{0.0, 0.0},
                                 {60.0, -100.0},
                                 {-20.0, 100.0},
                                 {150.0, 60.0},
                                 {-100.0, -110.0},
                                 {100.0, 90.0}})
    EXPECT_GT(backbone_reach(phi * degrees, psi * degrees), 1.1) << phi << ", " << psi;
}

TEST(TorsionPreferences, BackboneTurnsToTheEdgeOfTheNearestRegion) {
  for (double phi = -180.0; phi < 180.0; phi += 7.0)
    for (double psi = -180.0; psi < 180.0; psi += 7.0) {
      const double x = phi * degrees, y = psi * degrees, here = backbone_reach(x, y);
      const BackboneTurn turn = backbone_turn(x, y, 1.2);
      if (here <= 1.2) {
        EXPECT_EQ(turn.phi, 0.0);
        EXPECT_EQ(turn.psi, 0.0);
      } else {
        // Regions overlap: on the way to the edge of one it may come into another.
        EXPECT_LE(backbone_reach(x + turn.phi, y + turn.psi), 1.2 + 1e-9) << phi << ", " << psi;
        EXPECT_LT(backbone_reach(x + 0.5 * turn.phi, y + 0.5 * turn.psi), here);
      }
    }
}

TEST(TorsionPreferences, BadOnesAreRefused) {
  EXPECT_THROW(check({.staggered = {{{0, 1, 2, 4}, 0.3}}}, 4), InputError);
  EXPECT_THROW(check({.staggered = {{{0, 1, 2, 0}, 0.3}}}, 4), InputError);
  EXPECT_THROW(check({.staggered = {{{0, 1, 2, 3}, 2.0}}}, 4), InputError);
  EXPECT_THROW(check({.backbone = {{{0, 1, 2, 3, 4}, 0.0}}}, 5), InputError);
  EXPECT_NO_THROW(check({.staggered = {{{0, 1, 2, 3}, 0.3}}}, 4));
}

}  // namespace pliant::edits_test
