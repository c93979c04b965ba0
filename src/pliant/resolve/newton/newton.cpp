// SPDX-License-Identifier: MIT
#include "pliant/resolve/newton/newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/resolve/equations/bar_loops.hpp"

namespace pliant {

JointScales joint_scales(const BarEquations& equations) {
  JointScales scales;
  for (std::uint32_t j = 0; j < equations.joint_count(); ++j)
    scales.masses.push_back(equations.weight(j) > 0.0 ? 1.0 / equations.weight(j) : 0.0);
  scales.allowed.assign(scales.masses.size(), infinity);
  for (std::uint32_t k = 0; k < equations.bar_count(); ++k)
    for (const std::uint32_t j : {equations.ends(k).a, equations.ends(k).b})
      scales.allowed[j] = std::min(scales.allowed[j], equations.allowed(k));
  return scales;
}

PartResult NearestPoint::solve(Part part, std::span<const Vec3> broken, const ResolveCall& call,
                               const MayGoOn& may_go_on) {
  reserve();
  broken_ = broken;
  key_ = call.key;
  PartResult result;
  result.off_nearest = 0.0;
  copy(part, equations_.positions(), kept_);
  if (!newton_.is_overbraced(part) && iterate(part, may_go_on, result)) return result;
  copy(part, kept_, equations_.positions());
  if (restore(part, may_go_on, result)) slide(part, may_go_on, result);
  return result;
}

void NearestPoint::reserve() {
  if (masses_.size() == equations_.joint_count()) return;
  JointScales scales = joint_scales(equations_);
  masses_ = std::move(scales.masses);
  allowed_ = std::move(scales.allowed);
  for (auto* of_bars : {&lambda_, &bars_}) of_bars->resize(equations_.bar_count());
  for (auto* of_joints : {&restoring_, &sliding_, &kept_, &residual_, &direction_, &curved_})
    of_joints->resize(masses_.size());
}

/// Whole steps n + t from where the positions are, as long as they become smaller. kept_ is then
/// the least broken of what was seen.
bool NearestPoint::iterate(Part part, const MayGoOn& may_go_on, PartResult& result) {
  double least = infinity, least_error = infinity;
  int bad_steps = 0;
  for (;;) {
    const BarEquations::Errors errors = equations_.measure(part);
    if (errors.coincident || !errors.finite) return false;
    if (errors.worst < least_error) {
      least_error = errors.worst;
      result.whole = errors.whole;
      copy(part, equations_.positions(), kept_);
    }
    if (!may_go_on()) return result.whole && errors.whole;
    find_moves(part, infinity, result);
    if (errors.whole && asked(part, sliding_) <= 1.0) {
      polish(part, errors);
      result.whole = true;
      return true;
    }
    add(part, 1.0, sliding_, restoring_);
    const double size = asked(part, restoring_);
    if (!(size < 0.9 * least) && ++bad_steps > nearest_bad_steps) return false;
    least = std::min(least, size);
    add(part, 1.0, restoring_, equations_.positions());
  }
}

/// The last move is known already: it is taken if no bar becomes worse by it.
void NearestPoint::polish(Part part, const BarEquations::Errors& before) {
  copy(part, equations_.positions(), kept_);
  add(part, 1.0, restoring_, equations_.positions());
  add(part, 1.0, sliding_, equations_.positions());
  const BarEquations::Errors after = equations_.measure(part);
  if (!after.whole || after.worst > std::max(before.worst, 0.5))
    copy(part, kept_, equations_.positions());
}

bool NearestPoint::restore(Part part, const MayGoOn& may_go_on, PartResult& result) {
  const PartResult restored = newton_.make_whole(part, key_, may_go_on);
  result.iterations += restored.iterations;
  result.dropped_bars = restored.dropped_bars;
  result.whole = restored.whole;
  return restored.whole;
}

/// From whole positions to nearer whole ones, each step held to what brings it nearer.
void NearestPoint::slide(Part part, const MayGoOn& may_go_on, PartResult& result) {
  constexpr int most_failures = 8, most_steps = 30;
  double radius = distance(part);
  int failures = 0;
  for (int step = 0; step < most_steps && failures < most_failures && may_go_on(); ++step) {
    equations_.measure(part);
    find_moves(part, radius, result);
    const double length = std::sqrt(product(part, sliding_, sliding_));
    if (asked(part, sliding_) <= 1.0 || length < 0.03 * distance(part)) break;
    if (try_slide(part, may_go_on, result)) {
      radius = std::max(radius, 2.0 * length);
      failures = 0;
    } else {
      radius = 0.25 * length;
      ++failures;
    }
  }
  copy(part, equations_.positions(), kept_);
  if (!iterate(part, may_go_on, result)) {
    copy(part, kept_, equations_.positions());
    result.whole = equations_.measure(part).whole;
  }
}

bool NearestPoint::try_slide(Part part, const MayGoOn& may_go_on, PartResult& result) {
  const double before = distance(part);
  copy(part, equations_.positions(), kept_);
  add(part, 1.0, sliding_, equations_.positions());
  if (restore(part, may_go_on, result) && distance(part) < before) return true;
  copy(part, kept_, equations_.positions());
  result.whole = true;
  return false;
}

/// n and t at the positions just measured; |t| is at most `radius` (mass-weighted).
void NearestPoint::find_moves(Part part, double radius, PartResult& result) {
  result.dropped_bars = equations_.factor(part, equations_.directions());
  ++result.iterations;
  find_restoring_move(part);
  find_multipliers(part);
  find_sliding_move(part, radius);
  result.off_nearest = largest(part, sliding_);
}

/// n = -W J^T (J W J^T)^-1 C.
void NearestPoint::find_restoring_move(Part part) {
  equations_.solve(part, equations_.excess());
  clear(part, restoring_);
  equations_.pull(part, equations_.directions(), equations_.excess(), restoring_);
}

/// lambda = -(J W J^T)^-1 J (x - y), and residual_ = x - y + W J^T lambda.
void NearestPoint::find_multipliers(Part part) {
  const std::span<const Vec3> x = equations_.positions();
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j)
    residual_[j] = x[j] - broken_[j];
  project(part, residual_);
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) lambda_[k] = -bars_[k];
}

/// Takes from v what is not a move that keeps the bars to first order: v -= W J^T (J W J^T)^-1 J v.
void NearestPoint::project(Part part, std::span<Vec3> v) {
  equations_.stretch(part, equations_.directions(), v, bars_);
  equations_.solve(part, bars_);
  equations_.pull(part, equations_.directions(), bars_, v);
}

/// Whether any bar pulls: none does at the broken positions, which are nearest to themselves.
bool NearestPoint::is_loaded(Part part) const {
  bool any = false;
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) any |= lambda_[k] != 0.0;
  return any;
}

/// Conjugate gradients, all vectors multiplied by W: then the preconditioned residual is the
/// residual.
void NearestPoint::find_sliding_move(Part part, double radius) {
  clear(part, sliding_);
  if (!is_loaded(part)) return;
  clear(part, curved_);
  add_bent(part, restoring_, curved_);
  project(part, curved_);
  add(part, 1.0, curved_, residual_);
  clear(part, direction_);
  add(part, -1.0, residual_, direction_);
  const double first = product(part, residual_, residual_);
  double squared = first;
  for (int i = 0; i < most_inner_iterations; ++i) {
    if (!(squared > inner_accuracy * inner_accuracy * first)) return;
    if (!search(part, radius, squared)) return;
  }
}

/// One step of conjugate gradients; false where the model bends down or the radius is met.
bool NearestPoint::search(Part part, double radius, double& squared) {
  copy(part, direction_, curved_);
  add_bent(part, direction_, curved_);
  const double curvature = product(part, direction_, curved_);
  const double step = curvature > 0.0 ? squared / curvature : infinity;
  if (!is_within(part, step, radius)) {
    add(part, step_to(part, radius), direction_, sliding_);
    return false;
  }
  add(part, step, direction_, sliding_);
  add(part, step, curved_, residual_);
  project(part, residual_);
  const double next = product(part, residual_, residual_);
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j)
    direction_[j] = (next / squared) * direction_[j] - residual_[j];
  squared = next;
  return true;
}

/// Whether |sliding_ + step direction_| is below `radius` (mass-weighted).
bool NearestPoint::is_within(Part part, double step, double radius) const {
  if (!std::isfinite(radius)) return std::isfinite(step);
  const double length_squared = product(part, sliding_, sliding_) +
                                2.0 * step * product(part, sliding_, direction_) +
                                step * step * product(part, direction_, direction_);
  return length_squared < radius * radius;
}

/// The step along direction_ to the radius; without one, as far as if nothing bent.
double NearestPoint::step_to(Part part, double radius) const {
  const double ss = product(part, sliding_, sliding_);
  if (!std::isfinite(radius)) return ss > 0.0 ? 0.0 : 1.0;
  const double sd = product(part, sliding_, direction_);
  const double dd = product(part, direction_, direction_);
  return (std::sqrt(std::max(0.0, sd * sd + dd * (radius * radius - ss))) - sd) / dd;
}

void NearestPoint::add_bent(Part part, std::span<const Vec3> v, std::span<Vec3> out) const {
  bend_joints(equations_.pattern(part), lambda_.data() + part.bars.begin,
              v.data() + part.joints.begin, out.data() + part.joints.begin);
}

double NearestPoint::product(Part part, std::span<const Vec3> v, std::span<const Vec3> w) const {
  const std::uint32_t first = part.joints.begin;
  return weighted_product<double>(masses_.data() + first, v.data() + first, w.data() + first,
                                  part.joints.size());
}

/// Mass-weighted distance from the broken positions.
double NearestPoint::distance(Part part) {
  double sum = 0.0;
  const std::span<const Vec3> x = equations_.positions();
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j)
    sum += masses_[j] * norm_squared(x[j] - broken_[j]);
  return std::sqrt(sum);
}

double NearestPoint::largest(Part part, std::span<const Vec3> move) const {
  double squared = 0.0;
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j)
    squared = std::max(squared, norm_squared(move[j]));
  return std::sqrt(squared);
}

/// The largest move, in units of the error that the bars of its joint are allowed.
double NearestPoint::asked(Part part, std::span<const Vec3> move) {
  const std::uint32_t first = part.joints.begin;
  return std::sqrt(asked_squared<double>(allowed_.data() + first,
                                         equations_.positions().data() + first, move.data() + first,
                                         part.joints.size()));
}

void NearestPoint::clear(Part part, std::span<Vec3> v) const {
  std::fill(v.begin() + part.joints.begin, v.begin() + part.joints.end, Vec3{});
}

void NearestPoint::add(Part part, double factor, std::span<const Vec3> v,
                       std::span<Vec3> out) const {
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j) out[j] += factor * v[j];
}

void NearestPoint::copy(Part part, std::span<const Vec3> from, std::span<Vec3> to) const {
  std::copy(from.begin() + part.joints.begin, from.begin() + part.joints.end,
            to.begin() + part.joints.begin);
}

std::unique_ptr<Method> make_newton(const Framework& framework, const Technique&,
                                    const ResolveOptions& options) {
  return make_direct_method(framework, options, [](BarEquations& equations) {
    return std::unique_ptr<PartSolver>(std::make_unique<NearestPoint>(equations));
  });
}

}  // namespace pliant
