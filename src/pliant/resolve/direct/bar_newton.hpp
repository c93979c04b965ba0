// SPDX-License-Identifier: MIT
// Newton's method on the bars of one part of BarEquations, all at once. Each iteration is the
// smallest weighted move that satisfies the bars to first order, so the error squares from one to
// the next.
//
// Where bars are redundant (planar centres, cages with angles) J W J^T is singular or nearly so.
// Then its diagonal is raised in proportion to the error left (Levenberg, Marquardt), which costs
// iterations but no accuracy, for redundant bars ask for nothing that others forbid.
#pragma once

#include <functional>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/resolve/direct/bar_equations.hpp"

namespace pliant {

/// Asked before each iteration; false ends it.
using MayGoOn = std::function<bool()>;

/// How solving a part went.
struct PartResult {
  bool whole = false;
  std::int64_t iterations = 0;
  std::int64_t dropped_bars = 0;  ///< dependent bars left out of the last matrix
  /// The largest move towards the nearest whole positions that was still asked for (Angstrom); -1
  /// where these were not looked for.
  double off_nearest = -1.0;
};

/// Scratch for making parts of `equations` whole. Appending parts afterwards is allowed.
class BarNewton {
 public:
  explicit BarNewton(BarEquations& equations) : equations_(equations) {}

  /// Moves equations.positions() of the part until its bars are within the tolerance, or the error
  /// stops falling: the positions are then as good as they got. Coincident joints and lengths that
  /// are not finite are left as they are.
  /// `key` is what pushes out of local minima depend on.
  PartResult make_whole(BarEquations::Part part, const RandomKey& key, const MayGoOn& may_go_on);

  /// Rings and cages of bonds have one to one and a half bars a joint; with 1-3 bars there are two
  /// and more, and where centres are planar some depend on others.
  static bool is_overbraced(BarEquations::Part part);

 private:
  using Part = BarEquations::Part;

  double iterate(Part part, double error, const MayGoOn& may_go_on, PartResult& result);
  double iterate_damped(Part part, double error, const RandomKey& key, const MayGoOn& may_go_on,
                        PartResult& result);
  double descend(Part part, double error, const MayGoOn& may_go_on, PartResult& result);
  double push_broken(Part part, std::uint64_t push, RandomKey key);
  double step(Part part, double damping, PartResult& result);
  void copy(Part part, std::span<const Vec3> from, std::span<Vec3> to) const;

  BarEquations& equations_;
  std::vector<Vec3> best_;    ///< of the joints of the equations, since the last push
  std::vector<Vec3> least_;   ///< and of all
  std::vector<bool> pushed_;  ///< of the joints
  bool ended_ = false;        ///< there is to be no other iteration
};

}  // namespace pliant
