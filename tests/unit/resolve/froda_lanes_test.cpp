// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/pull/froda_lanes.hpp"

#include <random>

#include "pliant/base/math/elementary.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/framework/sterics.hpp"
#include "pliant/resolve/bodies/near/near_hits.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "pliant/resolve/bodies/tree/turn_springs.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"

namespace pliant::froda_lanes_test {

using test::Molecule;

/// Spheres that are `least` apart (Angstrom), a limit between the first atom and the last where
/// these have no bar, and torsion preferences about every third bond that can turn.
Molecule molecule(const std::string& file, double least) {
  const Structure structure = test::bonded(molecule_file(file));
  BuildOptions options{.bars = BarKind::angles};
  const Framework bare = build_framework(structure, options);
  auto sterics = test::spheres(bare.joint_count(), least);
  options.sterics = sterics;
  sterics->own = own_distances(build_framework(structure, options), structure.positions);
  const auto last = static_cast<Joint>(bare.joint_count() - 1);
  const double apart = distance(structure.positions.front(), structure.positions.back());
  const bool is_barred = std::any_of(bare.bars().begin(), bare.bars().end(), [&](Bar bar) {
    return std::min(bar.a, bar.b) == 0 && std::max(bar.a, bar.b) == last;
  });
  if (!is_barred)
    options.limits = {{0, last, 0.0, apart + 0.5, LimitKind::given, 0.0, no_limit_group}};
  auto wanted = std::make_shared<TorsionPreferences>();
  for (Joint k = 0; k + 4 < bare.joint_count(); k += 3)
    wanted->staggered.push_back({{k, k + 1, k + 2, k + 3}, 0.1});
  options.torsion_preferences = wanted;
  return {build_framework(structure, options), structure.positions};
}

FrodaOptions careful() { return {.is_careful = true, .has_torsion_preferences = true}; }

/// Three of a molecule, side by side.
Molecule three_of(const Molecule& one) {
  FrameworkParts parts = test::copies_of(one.framework, one.start, 3, {0, 0, 7}).parts();
  const std::vector<Vec3> start = parts.drawn;
  auto sterics = test::spheres(parts.joint_count, one.framework.sterics()->least[0]);
  parts.sterics = sterics;
  sterics->own = own_distances(Framework(parts), start);
  return {Framework(std::move(parts)), start};
}

/// What each of some frames is asked for: some wait for several targets on the way. The third is
/// asked for nothing, and every fourth without the limit.
struct Frames {
  std::vector<std::vector<Vec3>> targets, out;
  std::vector<std::uint8_t> off{1};

  Frames(const Molecule& m, std::size_t count) : out(count, m.start) {
    for (std::size_t k = 0; k < count; ++k)
      targets.push_back(test::shake(m.framework, m.start, k == 2 ? 0.0 : 0.8 * double(k % 7), k));
  }
  LimitsOff limits_off(std::size_t k) const {
    return k % 4 == 3 && has_limit ? LimitsOff(off) : LimitsOff();
  }
  bool has_limit = true;
};

void expect_those_of_a_solver(const Molecule& m, const LaneKernels& kernels, std::size_t count) {
  const auto plan = BodyPlan::make(m.framework);
  ASSERT_TRUE(plan && FrodaLanes::can_take(*plan));
  Frames frames(m, count);
  frames.has_limit = !m.framework.limits().empty();
  std::vector<FrodaJob> jobs;
  FrodaLanes lanes(m.framework, *plan, kernels);
  for (int again = 0; again < 2; ++again) {  // nothing is left over from the first time
    jobs.clear();
    for (std::size_t k = 0; k < count; ++k)
      jobs.push_back({{m.start, frames.targets[k], frames.limits_off(k)}, frames.out[k]});
    lanes.resolve(jobs, careful());
  }
  FrodaSolver solver(m.framework, *plan);
  std::vector<Vec3> alone = m.start;
  for (std::size_t k = 0; k < count; ++k) {
    const FrodaResult result =
        solver.resolve(m.start, frames.targets[k], alone, careful(), frames.limits_off(k));
    EXPECT_EQ(frames.out[k], alone) << k << " of " << count;
    EXPECT_EQ(jobs[k].result.is_whole, result.is_whole) << k;
    EXPECT_EQ(jobs[k].result.steps, result.steps) << k;
    EXPECT_EQ(jobs[k].result.max_overlap, result.max_overlap) << k;
    EXPECT_EQ(jobs[k].result.max_limit, result.max_limit) << k;
  }
}

/// To the last bit, on all levels, however many stand side by side.
TEST(FrodaLanes, FramesAreBitForBitThoseOfASolver) {
  for (const LaneKernels* kernels : lane_levels())
    for (const char* file : {"peptide_20.pdb", "cholesterol.cif", "butane.sdf"})
      for (const double least : {1.3, 2.2})  // some frames have no contacts, or all have
        for (const std::size_t count : {1, 2, 3, 8, 21}) {
          SCOPED_TRACE(std::string(kernels->level) + " " + file + " " + std::to_string(least));
          expect_those_of_a_solver(molecule(file, least), *kernels, count);
        }
}

/// Several molecules, and one that cannot turn at all.
TEST(FrodaLanes, TakeManyTreesAndNoTurns) {
  for (const LaneKernels* kernels : lane_levels()) {
    SCOPED_TRACE(kernels->level);
    expect_those_of_a_solver(three_of(molecule("butane.sdf", 2.2)), *kernels, 9);
    expect_those_of_a_solver(molecule("benzene.sdf", 1.3), *kernels, 9);
    expect_those_of_a_solver(three_of(molecule("benzene.sdf", 2.2)), *kernels, 9);
  }
}

TEST(FrodaLanes, TakeNoCutLoops) {
  const Molecule ring = molecule("crown_18_6.cif", 1.3);
  EXPECT_FALSE(FrodaLanes::can_take(*BodyPlan::make(ring.framework)));
}

struct Points {
  std::vector<float> x, y, z;
};

Points random_points(std::uint32_t count) {
  std::mt19937 random(7);
  const auto coordinate = [&] { return static_cast<float>(random() % 10000) * 1e-3F; };
  Points points;
  for (std::uint32_t k = 0; k < count; ++k) {
    points.x.push_back(coordinate());
    points.y.push_back(coordinate());
    points.z.push_back(coordinate());
  }
  return points;
}

float square_of(const Points& points, std::uint32_t a, std::uint32_t b) {
  const float x = points.x[a] - points.x[b], y = points.y[a] - points.y[b],
              z = points.z[a] - points.z[b];
  return x * x + y * y + z * z;
}

TEST(NearHits, AreThoseOfEachDistanceInRunsOfAnyLength) {
  const Points points = random_points(40 + points_beyond);
  const float widest = 25.0F;
  for (const FindNearHits find : near_hits_finders())
    for (std::uint32_t from = 0; from < 8; ++from)
      for (std::uint32_t to = from; to <= 40; ++to) {
        std::vector<float> squares(40 + points_beyond);
        const std::array<NearRun, 2> runs{NearRun{from, to}, NearRun{0, from / 2}};
        std::vector<std::uint32_t> hits(to - from + from / 2 + hits_beyond), expected;
        const NearPoints arrays{points.x.data(), points.y.data(), points.z.data()};
        hits.resize(find(arrays, runs, 11, widest, squares.data(), hits.data()));
        for (const NearRun run : runs)
          for (std::uint32_t m = run.from; m < run.to; ++m) {
            EXPECT_EQ(squares[m], square_of(points, m, 11));
            if (squares[m] < widest) expected.push_back(m);
          }
        EXPECT_EQ(hits, expected) << from << " to " << to;
      }
}

constexpr double degrees = std::numbers::pi / 180.0;

/// Four joints of a chain with bars for bonds and angles, its ends far out as those of long side
/// chains, whose one torsion is `torsion` degrees.
std::vector<Vec3> chain(double torsion) {
  const double c = std::cos(torsion * degrees), s = std::sin(torsion * degrees);
  return {{-0.5, 8.0, 0}, {0, 0, 0}, {1.5, 0, 0}, {2.0, 8.0 * c, 8.0 * s}};
}

Framework framework_of(const std::vector<Vec3>& drawn, double free, bool is_reversed) {
  FrameworkParts parts{
      .joint_count = 4, .bars = {{0, 1}, {1, 2}, {2, 3}, {0, 2}, {1, 3}}, .drawn = drawn};
  for (Bar bar : parts.bars) parts.rest_lengths.push_back(distance(drawn[bar.a], drawn[bar.b]));
  const std::array<Joint, 4> joints =
      is_reversed ? std::array<Joint, 4>{3, 2, 1, 0} : std::array<Joint, 4>{0, 1, 2, 3};
  parts.torsion_preferences = std::make_shared<const TorsionPreferences>(
      TorsionPreferences{.staggered = {{joints, free * degrees}}});
  // Spheres of no size, so that steps with contacts are taken at all.
  parts.sterics = test::spheres(4, 1.6, 2);
  return Framework(std::move(parts));
}

double torsion_of(std::span<const Vec3> x) {
  return torsion_angle(x[0], x[1], x[2], x[3]) / degrees;
}

/// Where a spring pulls, the angle asked for leads to the edge of what is usual, to first order
/// exactly: turns are about the bond.
TEST(TurnSprings, AskForTheEdgeOfWhatIsUsual) {
  for (const bool is_reversed : {false, true})
    for (double now = -178.0; now < 180.0; now += 4.0) {
      const std::vector<Vec3> x = chain(now);
      const Framework framework = framework_of(x, 20.0, is_reversed);
      const BodyPlan plan = *BodyPlan::make(framework);
      std::vector<Vec3> placed;
      for (Joint joint : plan.joint_at()) placed.push_back(x[joint]);
      TurnSprings springs(framework, plan);
      ASSERT_FALSE(springs.empty());
      const auto found = springs.at(placed, 50.0);
      ASSERT_EQ(found.size(), 1U);
      const double off = off_staggered(now * degrees) / degrees;
      if (std::abs(off) < 20.0) {
        EXPECT_EQ(found[0].weight, 0.0) << now;
        EXPECT_EQ(found[0].force, 0.0) << now;
        continue;
      }
      EXPECT_EQ(found[0].weight, 50.0) << now;
      EXPECT_NEAR(std::abs(found[0].force) / 50.0, (std::abs(off) - 20.0) * degrees, 1e-7) << now;
    }
}

/// What is pushed to an eclipsed torsion and rests there comes back towards staggered, whichever
/// way the torsion is named; without a preference it stays.
TEST(TurnSprings, PullAnEclipsedTorsionBack) {
  for (const bool is_reversed : {false, true})
    for (const double pushed : {100.0, 110.0, -20.0, 25.0}) {
      const std::vector<Vec3> start = chain(60.0);
      const auto turned_by = [&](double free) {
        const Framework framework = framework_of(start, free, is_reversed);
        const BodyPlan plan = *BodyPlan::make(framework);
        FrodaSolver solver(framework, plan);
        std::vector<Vec3> out(4);
        const FrodaResult result = solver.resolve(start, chain(pushed), out, careful());
        EXPECT_TRUE(result.is_whole);
        EXPECT_LT(measure(framework, out).max_relative, 1e-12);
        return torsion_of(out);
      };
      const double held = turned_by(15.0), free = turned_by(60.0);
      EXPECT_LT(std::abs(off_staggered(held * degrees)), std::abs(off_staggered(free * degrees)))
          << pushed << ": " << held << " and " << free;
    }
}

/// The ends may be no nearer than at 115 degrees, and the torsion prefers 60 to 75.
TEST(TurnSprings, LetGoWhereContactsWouldNotHoldAgainstThem) {
  const std::vector<Vec3> start = chain(118.0), nearest = chain(115.0);
  FrameworkParts parts = framework_of(start, 15.0, false).parts();
  auto sterics = test::spheres(4, distance(nearest[0], nearest[3]), 2);
  sterics->bonds = {{0, 1}, {1, 2}, {2, 3}};
  parts.sterics = sterics;
  const Framework framework(std::move(parts));
  const BodyPlan plan = *BodyPlan::make(framework);
  FrodaSolver solver(framework, plan);
  std::vector<Vec3> out(4);
  const FrodaResult result = solver.resolve(start, chain(80.0), out, careful());
  EXPECT_TRUE(result.is_whole);
  EXPECT_LE(result.max_overlap, careful().goal);
  EXPECT_NEAR(torsion_of(out), 115.0, 0.5);
}

}  // namespace pliant::froda_lanes_test
