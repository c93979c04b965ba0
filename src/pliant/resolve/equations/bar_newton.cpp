// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/bar_newton.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/resolve/equations/bar_loops.hpp"

namespace pliant {
PartResult BarNewton::make_whole(Part part, const RandomKey& key, const MayGoOn& may_go_on) {
  PartResult result;
  const BarEquations::Errors errors = equations_.measure(part);
  result.whole = errors.whole;
  if (errors.whole || errors.coincident || !errors.finite) return result;
  best_.resize(equations_.joint_count());
  copy(part, equations_.positions(), best_);
  ended_ = false;
  double best = errors.worst;
  if (!is_overbraced(part)) best = iterate(part, best, may_go_on, result);
  if (best > 1.0 && !ended_) {
    copy(part, best_, equations_.positions());
    equations_.measure(part);
    best = iterate_damped(part, best, key, may_go_on, result);
  }
  copy(part, best_, equations_.positions());
  result.whole = best <= 1.0;
  return result;
}

bool BarNewton::is_overbraced(Part part) { return part.bars.size() >= 2 * part.joints.size(); }

/// Moves once; the new error in units of what is allowed, infinite where it cannot go on.
double BarNewton::step(Part part, double damping, PartResult& result) {
  result.dropped_bars = equations_.factor(part, equations_.directions(), damping);
  equations_.solve(part, equations_.excess());
  equations_.pull(part, equations_.directions(), equations_.excess(), equations_.positions());
  ++result.iterations;
  const BarEquations::Errors errors = equations_.measure(part);
  if (errors.coincident || !errors.finite) return infinity;
  return errors.whole ? std::min(errors.worst, 1.0) : std::max(errors.worst, std::nextafter(1, 2));
}

double BarNewton::iterate(Part part, double error, const MayGoOn& may_go_on, PartResult& result) {
  // Newton may take a step or two to come near; after that each must pay.
  double best = error;
  int bad_steps = 0;
  while (std::isfinite(error) && best > 1.0) {
    ended_ = !may_go_on();
    if (ended_) break;
    error = step(part, 0.0, result);
    if (!(error < 0.9 * best) && ++bad_steps > newton_bad_steps) break;
    if (error < best) {
      best = error;
      copy(part, equations_.positions(), best_);
    }
  }
  return best;
}

/// Redundant bars have places where the error is least nearby, as when one atom of a flat ring has
/// come out on the wrong side. A push of the joints around what is broken leaves them.
double BarNewton::iterate_damped(Part part, double error, const RandomKey& key,
                                 const MayGoOn& may_go_on, PartResult& result) {
  constexpr std::uint64_t most_pushes = 12;
  double least = error;
  least_.resize(best_.size());
  copy(part, best_, least_);
  for (std::uint64_t push = 0;; ++push) {
    error = descend(part, error, may_go_on, result);
    if (error <= least) {
      least = error;
      copy(part, best_, least_);
    }
    if (least <= 1.0 || push == most_pushes || ended_) break;
    copy(part, best_, equations_.positions());
    error = push_broken(part, push, key);
  }
  copy(part, least_, best_);
  return least;
}

/// Levenberg and Marquardt's way: a step that does not pay is taken back and tried again shorter.
/// The damping falls with the error, so that it costs no digits at the end (Yamashita, Fukushima,
/// Computing Suppl. 15 (2001) 239).
double BarNewton::descend(Part part, double error, const MayGoOn& may_go_on, PartResult& result) {
  constexpr double most_damping = 1e6;
  constexpr int patience = 12;  // iterations in which the sum of squares must fall to a quarter
  double least = equations_.sum_of_squares(part), goal = 0.25 * least;
  double best = error, damping = 0.1;
  bool paid_before = true;
  int waited = 0;
  while (best > 1.0 && damping < most_damping && waited++ < patience) {
    ended_ = !may_go_on();
    if (ended_) break;
    error = step(part, damping * std::min(1.0, equations_.relative_error(part)), result);
    const double squares = std::isfinite(error) ? equations_.sum_of_squares(part) : infinity;
    const bool pays = squares < least;
    if (pays) {
      best = error;
      least = squares;
      copy(part, equations_.positions(), best_);
      if (paid_before) damping = std::max(1e-3, 0.3 * damping);
    } else {
      copy(part, best_, equations_.positions());
      equations_.measure(part);
      damping *= 4.0;
    }
    paid_before = pays;
    if (least < goal) {
      goal = 0.25 * least;
      waited = 0;
    }
  }
  return best;
}

/// Moves the ends of the bars that are broken most by a tenth of their length in any direction,
/// their centre of mass staying; returns the error then.
double BarNewton::push_broken(Part part, std::uint64_t push, RandomKey key) {
  constexpr double share_of_worst = 0.03, share_of_length = 0.1;
  const double worst = equations_.measure(part).worst;
  const auto x = equations_.positions();
  key.domain = Domain::escape;
  pushed_.assign(equations_.joint_count(), false);
  Vec3 moment;
  double mass = 0.0;
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) {
    const double off = std::abs(norm(equations_.directions()[k]) - equations_.rest(k));
    if (off <= std::max(1.0, share_of_worst * worst) * equations_.allowed(k)) continue;
    const auto [a, b] = equations_.ends(k);
    for (const std::uint32_t j : {std::min(a, b), std::max(a, b)}) {
      if (pushed_[j] || !(equations_.weight(j) > 0.0)) continue;
      pushed_[j] = true;
      key.joint = equations_.joint(j) + (push << 32);
      const Vec3 push_of_joint =
          share_of_length * equations_.rest(k) * equations_.random_direction(RandomSequence(key));
      x[j] += push_of_joint;
      moment += (1.0 / equations_.weight(j)) * push_of_joint;
      mass += 1.0 / equations_.weight(j);
    }
  }
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j)
    if (pushed_[j]) x[j] -= (1.0 / mass) * moment;
  copy(part, x, best_);
  const BarEquations::Errors errors = equations_.measure(part);
  return errors.finite && !errors.coincident ? errors.worst : infinity;
}

void BarNewton::copy(Part part, std::span<const Vec3> from, std::span<Vec3> to) const {
  std::copy(from.begin() + part.joints.begin, from.begin() + part.joints.end,
            to.begin() + part.joints.begin);
}

}  // namespace pliant
