// SPDX-License-Identifier: MIT
// The equations of bars that are solved at once, with the sparse matrix of all direct methods. For
// bar k with ends a and b and rest length L:
//
//   d_k = x_b - x_a,   C_k = |d_k| (|d_k| - L_k),   J the matrix of all d_k,   W = diag(weights)
//   (J W J^T) lambda = C,     x -= W J^T lambda
//
// is the smallest weighted move that satisfies the bars to first order. J W J^T has an entry for
// each pair of bars that share a moving joint. The d_k are not normalised, which saves a division
// and changes only the scale of lambda.
//
// Bars come in parts (components, blocks) without common bars. Each part has its own copy of its
// joints, side by side in memory in the sequence in which its bars are eliminated.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/equations/bar_elimination.hpp"
#include "pliant/resolve/equations/sparse_ldl.hpp"

namespace pliant {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

class BarEquations {
 public:
  using Range = SparseLdl::Range;
  /// Ranges of bars and of joints that are solved at once.
  struct Part {
    Range bars, joints;
  };

  /// Errors of the bars of a part.
  struct Errors {
    double worst = 0.0;       ///< largest |length - rest| divided by what is allowed
    bool whole = true;        ///< every bar is within the tolerance
    bool finite = true;       ///< every length is a finite number
    bool coincident = false;  ///< joints of some bar coincide, so that it has no direction
  };

  /// `weights` (N) are inverse masses or ones, and 0 for joints that never move.
  BarEquations(const Framework& framework, std::vector<double> weights, const Tolerance& tolerance);

  /// Adds the part with these bars. Returns none if its bars have so much fill (hubs of many bars,
  /// complete graphs) that memory and time would not be linear in them.
  std::optional<Part> append(std::span<const BarIndex> bars);

  std::size_t bar_count() const { return ends_.size(); }
  std::size_t joint_count() const { return joints_.size(); }
  BarIndex bar(std::uint32_t k) const { return bars_[k]; }
  Joint joint(std::uint32_t j) const { return joints_[j]; }
  EquationEnds ends(std::uint32_t k) const { return ends_[k]; }
  double rest(std::uint32_t k) const { return rests_[k]; }
  double allowed(std::uint32_t k) const { return allowed_[k]; }
  double weight(std::uint32_t j) const { return weights_[j]; }
  BarPattern pattern(Part part) const;

  /// A random direction in which joints may be pushed.
  Vec3 random_direction(RandomSequence draws) const { return framework_.random_direction(draws); }

  /// Positions of the joints of all parts, in the parts' own copies.
  std::span<Vec3> positions() { return x_; }
  void gather(Part part, std::span<const Vec3> from);
  /// Copies the joints that may move to `to`.
  void scatter(Part part, std::span<Vec3> to) const;

  /// Holds a joint of the framework fixed, as if its weight were 0; no_hold for none.
  static constexpr Joint no_hold = static_cast<Joint>(-1);
  void hold(Part part, Joint joint);

  /// Computes d and C of a part at positions().
  Errors measure(Part part);
  /// Largest |length - rest| / rest at the last measurement.
  double relative_error(Part part) const;
  /// Sum of (length - rest)^2 over the weights of both ends at the last measurement; damped steps
  /// reduce it.
  double sum_of_squares(Part part) const;
  std::span<const Vec3> directions() const { return d_; }  ///< d of all bars
  std::span<double> excess() { return excess_; }           ///< C of all bars
  /// Whether the joints of bar k coincide at positions(), so that it has no direction.
  bool is_coincident(std::uint32_t k) const;

  /// Factors J W J^T for these directions (of all bars), with each diagonal entry raised by
  /// `damping` times itself (Levenberg, Marquardt). Returns how many dependent bars were left out.
  std::int64_t factor(Part part, std::span<const Vec3> directions, double damping = 0.0);
  void solve(Part part, std::span<double> b) const { ldl_.solve(part.bars, b); }
  /// out = J v: from joints to bars.
  void stretch(Part part, std::span<const Vec3> directions, std::span<const Vec3> v,
               std::span<double> out) const;
  /// v -= W J^T lambda: from bars to joints.
  void pull(Part part, std::span<const Vec3> directions, std::span<const double> lambda,
            std::span<Vec3> v) const;

 private:
  void append_bars(std::span<const BarIndex> bars, std::span<const std::uint32_t> order, Part part);
  void weigh_entries(Part part);

  const Framework& framework_;
  std::vector<double> all_weights_;  ///< (N)
  Tolerance tolerance_;
  std::vector<std::uint32_t> place_;  ///< (N) index of a joint in the part that is being added
  std::vector<BarIndex> bars_;
  std::vector<EquationEnds> ends_;
  std::vector<double> rests_, allowed_, per_allowed_;
  std::vector<Joint> joints_;
  std::vector<double> weights_;  ///< (joints_) 0 for held ones
  std::vector<Vec3> x_;          ///< (joints_)
  std::vector<Vec3> d_;
  std::vector<double> excess_;
  std::vector<double> couplings_;  ///< (entries of ldl_) signed weight of the shared joint
  std::vector<double> diagonal_weights_;
  SparseLdl ldl_;
};

}  // namespace pliant
