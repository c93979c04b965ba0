// SPDX-License-Identifier: MIT
#include "pliant/resolve/shake/shake.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/resolve/equations/bar_loops.hpp"
#include "pliant/resolve/equations/direct_method.hpp"
#include "pliant/resolve/method/project_bar.hpp"

namespace pliant {
namespace {

/// Newton's method with the matrix of the reference, D W D^T, factored once: near the answer bars
/// hardly turn, so that each iteration gains a digit or more without factoring again. Each row is
/// scaled so that a bar alone would be met to second order.
class ShakeSolver final : public PartSolver {
 public:
  explicit ShakeSolver(BarEquations& equations) : equations_(equations), newton_(equations) {}

  PartResult solve(BarEquations::Part part, std::span<const Vec3> broken, const ResolveCall& call,
                   const MayGoOn& may_go_on) override {
    along_.resize(equations_.bar_count());
    best_.resize(equations_.joint_count());
    take_directions(part, call.reference);
    PartResult result;
    result.dropped_bars = equations_.factor(part, along_);
    if (iterate(part, may_go_on, result)) return result;
    // No answer along these directions that could be found: the nearest one instead.
    copy(part, broken, equations_.positions());
    const PartResult made = newton_.make_whole(part, call.key, may_go_on);
    result.iterations += made.iterations;
    result.dropped_bars = made.dropped_bars;
    result.whole = made.whole;
    return result;
  }

 private:
  void take_directions(BarEquations::Part part, std::span<const Vec3> reference) {
    equations_.measure(part);
    for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) {
      along_[k] = equations_.directions()[k];
      if (reference.empty()) continue;
      const auto [a, b] = equations_.ends(k);
      const Vec3 d = reference[equations_.joint(b)] - reference[equations_.joint(a)];
      if (norm_squared(d) >= least_squared_length) along_[k] = d;
    }
  }

  bool iterate(BarEquations::Part part, const MayGoOn& may_go_on, PartResult& result) {
    double best = std::numeric_limits<double>::infinity();
    int bad_steps = 0;
    for (;;) {
      const BarEquations::Errors errors = equations_.measure(part);
      if (errors.whole) {
        result.whole = true;
        return true;
      }
      if (errors.coincident || !errors.finite) return false;
      if (!(errors.worst < 0.9 * best) && ++bad_steps > shake_bad_steps) return false;
      best = std::min(best, errors.worst);
      if (!may_go_on()) return false;
      step(part);
      ++result.iterations;
    }
  }

  void step(BarEquations::Part part) {
    const std::span<double> excess = equations_.excess();
    for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k)
      excess[k] *= norm_squared(along_[k]) / dot(along_[k], equations_.directions()[k]);
    equations_.solve(part, excess);
    equations_.pull(part, along_, excess, equations_.positions());
  }

  static void copy(BarEquations::Part part, std::span<const Vec3> from, std::span<Vec3> to) {
    std::copy(from.begin() + part.joints.begin, from.begin() + part.joints.end,
              to.begin() + part.joints.begin);
  }

  BarEquations& equations_;
  BarNewton newton_;
  std::vector<Vec3> along_;  ///< of bars: d at the reference
  std::vector<Vec3> best_;   ///< of joints
};

}  // namespace

std::unique_ptr<Method> make_shake(const Framework& framework, const Technique&,
                                   const ResolveOptions& options) {
  return make_direct_method(framework, options, [](BarEquations& equations) {
    return std::unique_ptr<PartSolver>(std::make_unique<ShakeSolver>(equations));
  });
}

}  // namespace pliant
