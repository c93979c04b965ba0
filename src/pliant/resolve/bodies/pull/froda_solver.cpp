// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/pull/froda_solver.hpp"

#include <optional>
#include <utility>

#include "pliant/resolve/bodies/pull/contact_steps.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_cuts = 200;

/// A molecule has bars of some 2 Angstrom; others are taken for large or small molecules.
double unit_of(const Framework& framework) {
  double sum = 0.0;
  for (double rest : framework.rest_lengths()) sum += rest;
  return sum > 0.0 ? 0.5 * sum / double(framework.bar_count()) : 1.0;
}

}  // namespace

FrodaSolver::FrodaSolver(const Framework& framework, const BodyPlan& plan, double unit)
    : frame_(framework, plan, unit), step_(plan, frame_.working(), unit), unit_(unit) {}

FrodaResult FrodaSolver::resolve(std::span<const Vec3> start, std::span<const Vec3> target,
                                 std::span<Vec3> out, const FrodaOptions& options,
                                 LimitsOff limits_off) {
  return resolve({start, target, limits_off}, out, options);
}

FrodaResult FrodaSolver::resolve(const FrodaPush& push, std::span<Vec3> out,
                                 const FrodaOptions& options) {
  frame_.begin(push, options);
  if (options.is_careful) {
    while (frame_.ask_for_careful_pull()) step();
  } else {
    pull();
  }
  return finish(out);
}

/// Resolves contacts alone, then loops.
FrodaResult FrodaSolver::finish(std::span<Vec3> out) {
  while (frame_.ask_for_contacts()) step();
  while (frame_.ask_for_closing()) step();
  return frame_.finish(out);
}

void FrodaSolver::pull() {
  for (int leg = 1; leg < frame_.legs(); ++leg) {
    frame_.ask_for_pull(double(leg) / frame_.legs(), false);
    step();
  }
  if (pull_blindly() && frame_.legs() == 1) return;
  if (!frame_.has_broken_contacts()) return;
  for (int k = 0; k < froda::last_pulls; ++k) {
    frame_.ask_for_pull(1.0, true);
    step();
  }
}

/// All blind pulls. True if the push is so small that contacts need none of their own.
bool FrodaSolver::pull_blindly() {
  double first = 0.0, moved = 0.0;
  for (int k = 0; k < froda::last_pulls; ++k) {
    frame_.ask_for_pull(1.0, false);
    moved = step();
    if (k == 0) first = moved;
    if (first <= froda::small_move * unit_ && moved <= froda::settled_share * first) break;
  }
  return first <= froda::small_move * unit_;
}

/// How far it moved the body that went furthest (Angstrom).
double FrodaSolver::step() {
  const double moved = step_.step(frame_.positions(), frame_.request());
  frame_.note_step();
  return moved;
}

PlannedFroda::PlannedFroda(const Framework& framework, BodyPlan bodies)
    : plan(std::move(bodies)), solver(framework, plan, unit_of(framework)) {}

std::unique_ptr<PlannedFroda> plan_froda(const Framework& framework) {
  std::optional<BodyPlan> plan = BodyPlan::make(framework);
  if (!plan || plan->cuts().size() > most_cuts) return nullptr;
  return std::make_unique<PlannedFroda>(framework, std::move(*plan));
}

}  // namespace pliant
