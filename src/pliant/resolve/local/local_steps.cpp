// SPDX-License-Identifier: MIT
#include "pliant/resolve/local/local_steps.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "pliant/resolve/local/local_solver.hpp"
#include "pliant/resolve/method/moved_joints.hpp"
#include "pliant/resolve/units/units.hpp"

namespace pliant {
namespace {

/// More joints than these are not few.
constexpr std::size_t most_pushed = 32;

class LocalSteps final : public Method {
 public:
  LocalSteps(const Framework& framework, std::unique_ptr<Method> whole)
      : framework_(framework), whole_(std::move(whole)) {}

  bool looks_near() const override {
    return !framework_.has_pinned_joints() && !framework_.is_planar() &&
           !framework_.drawn().empty();
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (call.moved == nullptr) return whole_->resolve(call, summary);
    if (is_small(call) && resolve_near(call, summary)) return Stop::converged;
    call.moved->put_back(call.positions);
    call.moved->note_all(call.positions);
    return whole_->resolve(call, summary);
  }

 private:
  static bool is_small(const ResolveCall& call) {
    return !call.reference.empty() && !call.disturbed.joints.empty() &&
           call.disturbed.joints.size() <= most_pushed;
  }

  bool resolve_near(const ResolveCall& call, ResolveSummary& summary) {
    if (!solver_) solver_ = std::make_unique<LocalSolver>(framework_);
    static const double w = std::getenv("PLIANT_W") ? std::atof(std::getenv("PLIANT_W")) : 12.0;
    solver_->set_weight(w);
    const LocalResult result =
        solver_->resolve(call.reference, call.positions, call.disturbed.joints);
    ++summary.sweeps;
    summary.projections += result.visits;
    static const bool debug = std::getenv("PLIANT_LOCAL_DEBUG") != nullptr;
    if (debug) {
      double follow = 0, most = 0;
      const Joint j = call.disturbed.joints[0];
      const Vec3 d = call.positions[j] - call.reference[j];
      int n = 0;
      solver_->visit_moved([&](Joint joint, Vec3 x) {
        ++n;
        if (joint == j) follow = dot(x - call.reference[j], d) / norm_squared(d);
        most = std::max(most, norm(x - call.positions[joint]));
      });
      double whole_follow = 0, whole_most = 0, whole_sum = 0, sum = 0;
      {
        std::vector<Vec3> copy(call.positions.begin(), call.positions.end());
        ResolveCall alone = call;
        alone.positions = copy;
        alone.moved = nullptr;
        alone.disturbed = {call.disturbed.root};
        ResolveSummary s2;
        whole_->resolve(alone, s2);
        whole_follow = dot(copy[j] - call.reference[j], d) / norm_squared(d);
        for (std::size_t k = 0; k < copy.size(); ++k) {
          whole_most = std::max(whole_most, norm(copy[k] - call.positions[k]));
          whole_sum += norm_squared(copy[k] - call.reference[k]);
        }
      }
      solver_->visit_moved([&](Joint joint, Vec3 x) { sum += norm_squared(x - call.reference[joint]); });
      std::fprintf(stderr, "whole %.4f %.4f %.4f %.4f\n", whole_follow, whole_most / norm(d), std::sqrt(whole_sum) / norm(d), std::sqrt(sum) / norm(d));
      std::fprintf(stderr, "local %d follow %.3f most %.3f way %.3f visits %d joints %d\n",
                   int(result.is_closed), follow, most / norm(d), norm(d), int(result.visits), n);
    }
    if (!result.is_closed) return false;
    solver_->visit_moved([&](Joint joint, Vec3 x) {
      call.moved->note(joint, call.positions[joint]);
      call.positions[joint] = x;
    });
    return true;
  }

  const Framework& framework_;
  std::unique_ptr<Method> whole_;
  std::unique_ptr<LocalSolver> solver_;
};

}  // namespace

std::unique_ptr<Method> make_local_units(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, make_units(framework, technique, options));
}

std::unique_ptr<Method> make_local_units_nearest(const Framework& framework,
                                                 const Technique& technique,
                                                 const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, make_units_nearest(framework, technique, options));
}

}  // namespace pliant
