// SPDX-License-Identifier: MIT
#include "pliant/path/path.hpp"

#include <future>

#include "pliant/base/math/superposition.hpp"
#include "pliant/path/detour.hpp"
#include "pliant/path/march.hpp"
#include "pliant/path/path_walker.hpp"
#include "pliant/path/turn_ways.hpp"
#include "support/test.hpp"
#include "unit/path/bent_helix.hpp"

namespace pliant::path_test {

using testing::Each;
using testing::HasSubstr;
using testing::Lt;
using testing::SizeIs;

/// r.m.s. distance of the alpha carbons of a frame from those of a structure, superposed.
double apart(const MolecularPath& path, const std::vector<Vec3>& frame, const Structure& end) {
  std::vector<Vec3> here, there;
  const AtomTable& atoms = path.ends->start.model.structure.atoms;
  for (std::size_t atom = 0; atom < atoms.size(); ++atom)
    if (atoms.names[atom] == "CA") here.push_back(frame[atom]);
  for (std::size_t atom = 0; atom < end.size(); ++atom)
    if (end.atoms.names[atom] == "CA") there.push_back(end.positions[atom]);
  const RigidMotion onto = superposition(here, there);
  double sum = 0.0;
  for (std::size_t k = 0; k < here.size(); ++k) sum += norm_squared(onto(here[k]) - there[k]);
  return std::sqrt(sum / double(here.size()));
}

TEST(Path, ArrivesWithEveryBarWhole) {
  const Structure start = helix(), end = bent(start, 9, 60.0);
  const MolecularPath path = find_path(start, end);
  EXPECT_TRUE(path.has_arrived);
  EXPECT_GT(path.frames.size(), 5U);
  EXPECT_GT(path.frames.front().to_end, 2.0);
  EXPECT_NEAR(path.frames.front().from_start, 0.0, 1e-9);
  EXPECT_NEAR(apart(path, path.positions.back(), end), path.frames.back().to_end, 1e-6);
  EXPECT_LT(path.frames.back().to_end, 0.5);
  EXPECT_LT(worst_bar(path), 1e-10);
  EXPECT_EQ(path.ends->matched, 20U);
  EXPECT_EQ(path.turned, 0.0);
}

TEST(Path, HoldsTheContactsOfBothAndLosesThoseOfTheStart) {
  const Structure start = helix();
  const MolecularPath path = find_path(start, bent(start, 9, 60.0));
  EXPECT_FALSE(path.ends->start.model.contacts.empty());
  EXPECT_FALSE(path.ends->to_lose.empty());
  EXPECT_EQ(path.frames.front().lost, 0);
  EXPECT_GT(path.frames.back().lost, 0);
  for (const PathFrame& frame : path.frames) {
    EXPECT_LT(frame.held_off, 0.011) << frame.step;
    EXPECT_LT(frame.overlap, 0.11) << frame.step;
  }
}

TEST(Path, TheSameAgainHasTheSameBits) {
  const Structure start = helix(), end = bent(start, 9, 60.0);
  for (const PathOptions& options :
       {PathOptions{}, PathOptions{.both = true}, PathOptions{.atoms = "heavy"}})
    EXPECT_EQ(find_path(start, end, options).positions, find_path(start, end, options).positions);
}

TEST(Path, BothEndsMeet) {
  const Structure start = helix(), end = bent(start, 9, 60.0);
  const MolecularPath path = find_path(start, end, {.both = true});
  EXPECT_TRUE(path.has_arrived);
  EXPECT_THAT(path.notes, SizeIs(2));
  EXPECT_THAT(path.notes.back(), HasSubstr("the two ends met, 0."));
  EXPECT_LT(worst_bar(path), 1e-10);
}

TEST(Path, TheSameStructureIsNoWay) {
  for (const bool both : {false, true}) {
    const MolecularPath path = find_path(helix(), helix(), {.both = both});
    EXPECT_TRUE(path.has_arrived);
    EXPECT_THAT(path.frames, SizeIs(1));
  }
}

TEST(Path, WhatIsStuckGoesBackAndKeepsWhatIsBest) {
  const Structure start = helix();
  Structure mirror = start;  // which no motion reaches
  for (Vec3& x : mirror.positions) x.x = -x.x;
  const MolecularPath straight = find_path(start, mirror);
  const MolecularPath again = find_path(start, mirror, {.backtrack = 2, .seed = 1});
  EXPECT_FALSE(straight.has_arrived);
  EXPECT_EQ(straight.attempts, 0);
  EXPECT_EQ(again.attempts, 2);
  EXPECT_LE(again.frames.back().to_end, straight.frames.back().to_end);
  EXPECT_LT(worst_bar(again), 1e-10);
}

TEST(PathWalk, GrowsStepByStepIntoTheSamePath) {
  const Structure start = helix(), end = bent(start, 9, 60.0);
  const auto ends = std::make_shared<const PathEnds>(match_ends(start, end));
  PathWalk walk(ends, {});
  EXPECT_EQ(walk.frame_count(), 1U);
  std::size_t before = 1;
  while (walk.advance()) {
    EXPECT_LE(walk.frame_count(), before + 1);
    before = walk.frame_count();
  }
  EXPECT_TRUE(walk.is_over());
  EXPECT_FALSE(walk.advance());
  EXPECT_EQ(found_by(walk).positions, find_path(start, end).positions);
  EXPECT_EQ(walk.frame(3).step, 3);
  EXPECT_DOUBLE_EQ(walk.frame(3).time, 0.03);
}

/// The steps in which it is stopped leave nothing behind.
TEST(PathWalk, GoesOnAfterItWasStopped) {
  const Structure start = helix(), end = bent(start, 9, 60.0);
  for (const bool both : {false, true}) {
    int asked = 0;
    PathOptions options{.both = both};
    const auto ends = std::make_shared<const PathEnds>(match_ends(start, end, options));
    options.should_stop = [&asked] { return ++asked % 7 == 0; };
    PathWalk walk(ends, options);
    while (walk.advance()) {
    }
    EXPECT_GT(asked, 14);
    const MolecularPath stopped = found_by(walk);
    EXPECT_TRUE(stopped.has_arrived);
    EXPECT_LT(worst_bar(stopped), 1e-10);
  }
}

TEST(PathWalk, EndsAtOnceWhereItIsStoppedFromOutside) {
  const Structure start = helix();
  const MolecularPath path =
      find_path(start, bent(start, 9, 60.0), {.should_stop = [] { return true; }});
  EXPECT_THAT(path.frames, SizeIs(1));
  EXPECT_FALSE(path.has_arrived);
}

TEST(PathTable, TightPlacesAreThoseThatOverlapMost) {
  std::vector<PathFrame> frames(5);
  const std::vector<std::pair<double, const char*>> rows{
      {0.1, "A"}, {0.3, "B"}, {0.0, ""}, {0.2, "A"}, {0.05, "C"}};
  for (std::size_t k = 0; k < rows.size(); ++k) {
    frames[k].step = std::int64_t(k);
    frames[k].overlap = rows[k].first;
    frames[k].tightest = rows[k].second;
  }
  const std::vector<TightPlace> places = tight_places(frames, 2);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].atoms, "B");
  EXPECT_EQ(places[1].atoms, "A");
  EXPECT_EQ(places[1].overlap, 0.2);
  EXPECT_EQ(places[1].step, 3);
  EXPECT_EQ(places[1].frames, 2);
}

TEST(PathOptions, OutOfRangeAreRefused) {
  const std::pair<const char*, PathOptions> cases[] = {
      {"step = 0: must be positive and finite", {.step = 0.0}},
      {"step = 2.5: must be at most 2 Angstrom", {.step = 2.5}},
      {"backtrack = -1: must be from 0", {.backtrack = -1}},
      {"backtrack = 1001: must be at most 1000", {.backtrack = 1001}},
      {"no atoms named \"all\"; known: CA, heavy", {.atoms = "all"}}};
  for (const auto& [text, options] : cases) EXPECT_ERROR(OptionError, text, check(options));
}

TEST(PathEnds, AnotherMoleculeIsRefused) {
  Structure drug = read_structure(molecule_file("caffeine.sdf"));
  EXPECT_THAT(test::error_text<InputError>([&] { match_ends(drug, helix()); }),
              HasSubstr("has no residues of proteins or nucleic acids"));
  EXPECT_THAT(test::error_text<InputError>([&] { match_ends(helix(), drug); }),
              HasSubstr("is it the same molecule"));
}

TEST(PathEnds, HeavyAtomsAreThoseOfTheSameName) {
  const PathEnds ends = match_ends(helix(), helix(), {.atoms = "heavy"});
  const Structure& structure = ends.start.model.structure;
  EXPECT_GT(ends.start.asked.size(), 100U);
  for (std::size_t k = 0; k < ends.goal.size(); ++k) {
    EXPECT_GT(structure.atoms.elements[ends.start.asked[k]], 1);
    EXPECT_EQ(ends.goal[k], structure.positions[ends.start.asked[k]]);
  }
  EXPECT_THAT(ends.start.leader, Each(Lt(20U)));
}

/// Two helices, one turned by 150 degrees: no straight line leads from one end to the other.
class TurnedHelix : public testing::Test {
 protected:
  const Structure start = helix(), end = bent_at_c(start, 10, 150.0);
};

TEST_F(TurnedHelix, IsReachedEitherWay) {
  for (const auto& [from, to] : {std::pair{&start, &end}, {&end, &start}}) {
    const MolecularPath path = find_path(*from, *to);
    EXPECT_TRUE(path.has_arrived);
    EXPECT_GT(path.turned, 135.0);
    EXPECT_LT(path.turned, 225.0);
    EXPECT_NEAR(path.frames.front().from_start, 0.0, 1e-9);
    EXPECT_LT(worst_bar(path), 1e-10);
    for (const PathFrame& frame : path.frames) {
      EXPECT_LT(frame.held_off, 0.011) << frame.step;
      EXPECT_LT(frame.overlap, 0.11) << frame.step;
    }
  }
}

TEST_F(TurnedHelix, HasTheSameBitsInEachOfSeveralThreads) {
  const auto walk = [this] { return find_path(end, start).positions; };
  auto one = std::async(std::launch::async, walk), other = std::async(std::launch::async, walk);
  const auto here = walk();
  EXPECT_EQ(one.get(), here);
  EXPECT_EQ(other.get(), here);
}

TEST_F(TurnedHelix, IsGoneToBothWaysRound) {
  const PathEnds ends = match_ends(start, end);
  const std::vector<TurnWay> found = find_turn_ways(ends.start, ends.goal);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].angle + found[1].angle, 360.0, 1e-9);
  EXPECT_NEAR(std::min(found[0].angle, found[1].angle), 150.0, 15.0);
  EXPECT_LE(found[0].clashes, found[1].clashes);
  for (const TurnWay& way : found) {
    EXPECT_EQ(way.goals.back(), ends.goal);
    EXPECT_GT(way.goals.size(), 4U);
    std::vector<Vec3> before = asked_of(ends.start, ends.start.model.positions);
    for (const std::vector<Vec3>& goal : way.goals) {
      EXPECT_LT(rms(ways(before, goal)), 2.0);
      before = goal;
    }
  }
}

TEST(TurnWays, SmallTurnsHaveNone) {
  const PathEnds ends = match_ends(helix(), bent(helix(), 9, 30.0));
  EXPECT_TRUE(find_turn_ways(ends.start, ends.goal).empty());
}

TEST(Patience, IsOverAtTheGoalAndWhereEightStepsGainTooLittle) {
  EXPECT_TRUE(Patience(0.2, 1.0).is_over(1e-7));
  Patience patience(0.2, 1.0);
  for (int step = 0; step < 7; ++step) EXPECT_FALSE(patience.is_over(0.999)) << step;
  EXPECT_TRUE(patience.is_over(0.999));
}

TEST(Patience, IsNotOverWhileStepsGainAndAsksForLessOfSmallOnes) {
  Patience large(0.2, 1.0), small(0.01, 1.0);
  for (int step = 1; step < 40; ++step) {
    EXPECT_FALSE(large.is_over(1.0 - 0.0026 * step)) << step;
    EXPECT_FALSE(small.is_over(1.0 - 0.0006 * step)) << step;
  }
}

TEST(Way, FirstPlacesAreWithoutNotes) {
  Way way;
  for (int k = 0; k < 3; ++k) way.add(std::make_shared<const PathPlace>(), double(k));
  way.notes.emplace_back("ended");
  const Way first = way.first(2);
  EXPECT_EQ(first.places.size(), 2U);
  EXPECT_EQ(first.left, (std::vector<double>{0.0, 1.0}));
  EXPECT_TRUE(first.notes.empty());
}

TEST(Ways, LeadToTheGoalWhereverItLies) {
  const std::vector<Vec3> here{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  std::vector<Vec3> goal;
  for (Vec3 x : here) goal.push_back(Vec3{-x.y, x.x, x.z} + Vec3{7, 8, 9});  // turned and shifted
  EXPECT_LT(rms(ways(here, goal)), 1e-14);
  EXPECT_EQ(rms({}), 0.0);
}

/// By NumPy: numbers of np.random.Philox(key=[9, 2]), smoothed by np.exp.
TEST(SmoothField, IsNumpysNoiseSmoothedAlongTheResidues) {
  const std::vector<Vec3> expected{{0.435407317830388, -0.544916922898782, -0.150685811439069},
                                   {0.597467749312418, -0.507064239336695, -0.160334902789632},
                                   {0.751039964457104, -0.441641205247073, -0.16282945032068},
                                   {0.87370789230756, -0.363110124701447, -0.157947383844347},
                                   {0.9467750813822, -0.286682564406719, -0.146390069809795},
                                   {0.959895403478058, -0.223636646676238, -0.129628732192128},
                                   {0.913387206529687, -0.178627107115408, -0.109624053720895}};
  const std::vector<Vec3> field = smooth_field(7, 2, 9);
  ASSERT_EQ(field.size(), expected.size());
  for (std::size_t k = 0; k < field.size(); ++k)
    EXPECT_LT(distance(field[k], expected[k]), 1e-13) << k;
}

TEST(SmoothField, ChangesSlowlyAlongALongChainAndIsOneAtMost) {
  const std::vector<Vec3> field = smooth_field(500, 1, 0);
  double longest = 0.0;
  for (Vec3 direction : field) longest = std::max(longest, norm(direction));
  EXPECT_NEAR(longest, 1.0, 1e-12);
  for (std::size_t k = 1; k < field.size(); ++k) EXPECT_LT(distance(field[k - 1], field[k]), 0.4);
}

TEST(SmoothField, DependsOnSeedAndAttempt) {
  EXPECT_EQ(smooth_field(20, 1, 0), smooth_field(20, 1, 0));
  EXPECT_NE(smooth_field(20, 1, 0), smooth_field(20, 2, 0));
  EXPECT_NE(smooth_field(20, 1, 0), smooth_field(20, 1, 1));
}

}  // namespace pliant::path_test
