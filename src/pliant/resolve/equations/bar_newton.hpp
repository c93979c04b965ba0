// SPDX-License-Identifier: MIT
// Newton's method on all bars of one part of BarEquations. Each iteration makes the smallest
// weighted move that satisfies the bars to first order, so that the error is squared from one to
// the next.
//
// With redundant bars (planar centres, cages with angles) J W J^T is singular or nearly so. Its
// diagonal is then raised in proportion to the error (Levenberg, Marquardt), which costs iterations
// but no accuracy, because redundant bars do not contradict the others.
#pragma once

#include <functional>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/resolve/equations/bar_equations.hpp"

namespace pliant {

/// Called before each iteration; false ends the solution.
using MayGoOn = std::function<bool()>;

/// The result of solving a part.
struct PartResult {
  bool whole = false;
  std::int64_t iterations = 0;
  std::int64_t dropped_bars = 0;  ///< dependent bars left out of the last matrix
  /// Largest move towards the nearest whole positions that remained to be made (Angstrom); -1 if
  /// these were not sought.
  double off_nearest = -1.0;
};

/// Makes parts of `equations` whole. Parts may be appended afterwards.
class BarNewton {
 public:
  explicit BarNewton(BarEquations& equations) : equations_(equations) {}

  /// Moves equations.positions() of the part until its bars are within the tolerance, or the error
  /// stops falling, which leaves the best positions found. Coincident joints and lengths that are
  /// not finite are not repaired. Pushes out of local minima depend on `key`.
  PartResult make_whole(BarEquations::Part part, const RandomKey& key, const MayGoOn& may_go_on);

  /// Whether damping is needed. Rings and cages of bonds have one to one and a half bars a joint;
  /// with 1-3 bars there are two and more, some of which are redundant at planar centres.
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
  std::vector<Vec3> best_;    ///< of the joints, since the last push
  std::vector<Vec3> least_;   ///< the same over all pushes
  std::vector<bool> pushed_;  ///< (joints)
  bool ended_ = false;        ///< no further iteration is allowed
};

}  // namespace pliant
