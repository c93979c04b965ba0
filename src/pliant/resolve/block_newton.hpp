// SPDX-License-Identifier: MIT
// Newton's method on the bars of one block, all at once, with one joint (where the block is
// entered) held still.
//
//   C_k = |x_b - x_a| - L_k,  n_k = (x_b - x_a) / |x_b - x_a|,  J the matrix of all n_k
//   (J W J^T) lambda = C,     x += W J^T lambda (towards shorter bars),  W = diag(weights)
//
// Each iteration is the smallest weighted move that satisfies the linearised bars, so the error
// squares from one to the next. J W J^T has an entry for each pair of bars that share a moving
// joint. It is singular where bars are redundant, as around planar centres; then its diagonal is
// raised in proportion to the error left (Levenberg, Marquardt), which costs iterations but no
// accuracy, for redundant bars ask for nothing that others forbid.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/residual.hpp"

namespace pliant {

/// The bars of one block, and what their equations share whatever the positions are.
class BlockNewton {
 public:
  /// Whether pairs of bars that share a joint are few enough for linear memory and time.
  static bool can_hold(const Framework& framework, std::span<const BarIndex> bars);
  /// `bars` are those of the block. `weights` (N) are inverse masses or ones, 0 for joints that
  /// never move.
  BlockNewton(const Framework& framework, std::vector<BarIndex> bars,
              std::span<const double> weights, const Tolerance& tolerance);
  ~BlockNewton();
  BlockNewton(BlockNewton&&) noexcept;

  enum class Outcome { whole, stalled, not_finite };

  /// Iterates until all bars of the block are within the tolerance, adding to `iterations`.
  /// stalled: the error stopped falling; positions are then as good as they got.
  Outcome solve(std::span<Vec3> positions, Joint entry, std::int64_t most_iterations,
                std::int64_t& iterations);

  std::span<const BarIndex> bars() const { return bars_; }
  std::span<const Joint> joints() const { return joints_; }

 private:
  struct BlockBar {
    std::uint32_t a, b;  ///< places in joints_
    double rest, allowed;
  };
  /// Two bars that share a joint: an entry of J W J^T below the diagonal.
  struct Coupling {
    std::uint32_t row, column;
    std::uint32_t joint;  ///< place in joints_
    double sign;          ///< +1 when the joint is the same end of both bars
  };
  class Factor;  ///< of J W J^T
  class DenseFactor;
  class SparseFactor;

  void index_joints(const Framework& framework);
  void couple_bars();
  void gather(std::span<const Vec3> positions, Joint entry);
  double measure_bars();
  void assemble(double damping);
  void move();
  void scatter(std::span<Vec3> positions) const;
  bool is_overbraced() const;
  double iterate(double error, std::int64_t most_iterations, std::int64_t& iterations);
  double iterate_damped(double error, std::int64_t most_iterations, std::int64_t& iterations);

  std::vector<BarIndex> bars_;
  std::vector<Joint> joints_;
  std::vector<BlockBar> block_bars_;
  std::vector<Coupling> couplings_;
  std::vector<double> weights_;   ///< of joints_, as given
  std::vector<double> moving_;    ///< of joints_, 0 at the entry
  std::vector<Vec3> x_, best_;    ///< of joints_
  std::vector<Vec3> directions_;  ///< of bars
  std::vector<double> errors_;    ///< C, then lambda
  double relative_error_ = 0.0;   ///< largest |C| / rest of the last measurement
  std::unique_ptr<Factor> factor_;
};

}  // namespace pliant
