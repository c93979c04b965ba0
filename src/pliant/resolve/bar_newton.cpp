// SPDX-License-Identifier: MIT
#include "pliant/resolve/bar_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant {

BarNewton::Outcome BarNewton::make_whole(Part part, const MayGoOn& may_go_on) {
  Outcome outcome;
  const BarEquations::Errors errors = equations_.measure(part);
  outcome.whole = errors.whole;
  if (errors.whole || errors.coincident || !errors.finite) return outcome;
  best_.resize(equations_.joint_count());
  keep(part);
  const double best = is_overbraced(part) ? iterate_damped(part, errors.worst, may_go_on, outcome)
                                          : iterate(part, errors.worst, may_go_on, outcome);
  take_back(part);
  outcome.whole = best <= 1.0;
  return outcome;
}

bool BarNewton::is_overbraced(Part part) const {
  return part.bars.size() >= 2 * part.joints.size();
}

/// Moves once; the new error in units of what is allowed, infinite where it cannot go on.
double BarNewton::step(Part part, double damping, Outcome& outcome) {
  outcome.dropped_bars = equations_.factor(part, equations_.directions(), damping);
  equations_.solve(part, equations_.excess());
  equations_.pull(part, equations_.directions(), equations_.excess(), equations_.positions());
  ++outcome.iterations;
  const BarEquations::Errors errors = equations_.measure(part);
  if (errors.coincident || !errors.finite) return std::numeric_limits<double>::infinity();
  return errors.whole ? std::min(errors.worst, 1.0) : std::max(errors.worst, std::nextafter(1, 2));
}

double BarNewton::iterate(Part part, double error, const MayGoOn& may_go_on, Outcome& outcome) {
  // Newton may take a step or two to come near; after that each must pay.
  constexpr int most_bad_steps = 3;
  double best = error;
  int bad_steps = 0;
  while (std::isfinite(error) && best > 1.0 && may_go_on()) {
    error = step(part, 0.0, outcome);
    if (!(error < 0.9 * best) && ++bad_steps > most_bad_steps) break;
    if (error < best) best = error, keep(part);
  }
  return best;
}

/// Levenberg and Marquardt's way: a step that does not pay is taken back and tried again shorter.
/// The damping falls with the error, so that it costs no digits at the end (Yamashita, Fukushima,
/// Computing Suppl. 15 (2001) 239).
double BarNewton::iterate_damped(Part part, double error, const MayGoOn& may_go_on,
                                 Outcome& outcome) {
  constexpr double most_damping = 1e6;
  double best = error, damping = 0.1;
  while (best > 1.0 && damping < most_damping && may_go_on()) {
    error = step(part, damping * std::min(1.0, equations_.relative_error(part)), outcome);
    if (error < best) {
      best = error;
      keep(part);
      damping = std::max(1e-3, 0.3 * damping);
    } else {
      take_back(part);
      equations_.measure(part);
      damping *= 4.0;
    }
  }
  return best;
}

void BarNewton::keep(Part part) {
  const auto x = equations_.positions();
  std::copy(x.begin() + part.joints.begin, x.begin() + part.joints.end,
            best_.begin() + part.joints.begin);
}

void BarNewton::take_back(Part part) {
  std::copy(best_.begin() + part.joints.begin, best_.begin() + part.joints.end,
            equations_.positions().begin() + part.joints.begin);
}

}  // namespace pliant
