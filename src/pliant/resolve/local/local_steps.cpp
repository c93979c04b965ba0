// SPDX-License-Identifier: MIT
#include "pliant/resolve/local/local_steps.hpp"

#include <cstdio>
#include <cstdlib>
#include <utility>

#include "pliant/resolve/froda/froda.hpp"
#include "pliant/resolve/local/local_solver.hpp"
#include "pliant/resolve/method/moved_joints.hpp"
#include "pliant/resolve/units/units.hpp"

namespace pliant {
namespace {

/// More joints than these are not few.
constexpr std::size_t most_pushed = 32;
/// Bodies of regions, each tried if the one before does not let pushed joints follow.
constexpr std::size_t sizes[] = {18, 72, 288};
/// Pushed joints of `units` are pulled this much more strongly than others: then they follow as far
/// as in the pass over all units, which places theirs first.
constexpr double weight_of_units = 12.0;
/// Joints that follow less than this share of a push, for each unit of their weight, are held back:
/// of random pushes on a protein one in 700 is in the smallest region, and none in the next.
constexpr double least_followed = 0.05 / 12.0;

class LocalSteps final : public Method {
 public:
  LocalSteps(const Framework& framework, const ResolveOptions& options, double weight,
             std::unique_ptr<Method> whole)
      : framework_(framework), options_(options), weight_(weight), whole_(std::move(whole)) {}

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
    if (!solver_)
      solver_ = std::make_unique<LocalSolver>(framework_, options_.tolerance,
                                              LocalOptions{.weight = weight_});
    const LocalPush push{call.reference, call.positions, call.disturbed.joints, call.limits_off,
                         call.neighbours};
    for (std::size_t size : sizes) {
      const LocalResult result = solver_->resolve(push, size);
      summary.projections += result.visits;
      static const bool debug = std::getenv("PLIANT_LOCAL_DEBUG") != nullptr;
      if (debug) {
        double most = 0, way = norm(push.target[push.joints[0]] - push.start[push.joints[0]]);
        int n = 0;
        solver_->visit_moved([&](Joint joint, Vec3 x) {
          ++n;
          most = std::max(most, norm(x - call.positions[joint]));
        });
        std::fprintf(stderr, "local %d follow %.3f most %.3f way %.3f visits %d joints %d size %d\n",
                     int(result.is_whole), result.followed, most / way, way, int(result.visits), n,
                     int(size));
      }
      if (!result.is_whole) continue;
      if (result.followed < least_followed * weight_ && !solver_->was_free()) continue;
      ++summary.sweeps;
      write(call);
      return true;
    }
    return false;
  }

  void write(const ResolveCall& call) const {
    solver_->visit_moved([&](Joint joint, Vec3 x) {
      call.moved->note(joint, call.positions[joint]);
      call.positions[joint] = x;
    });
  }

  const Framework& framework_;
  ResolveOptions options_;
  double weight_;
  std::unique_ptr<Method> whole_;
  std::unique_ptr<LocalSolver> solver_;
};

}  // namespace

std::unique_ptr<Method> make_local_units(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, options, weight_of_units,
                                      make_units(framework, technique, options));
}

std::unique_ptr<Method> make_local_units_nearest(const Framework& framework,
                                                 const Technique& technique,
                                                 const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, options, 1.0,
                                      make_units_nearest(framework, technique, options));
}

std::unique_ptr<Method> make_local_froda(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options) {
  return std::make_unique<LocalSteps>(framework, options, 1.0,
                                      make_froda(framework, technique, options));
}

}  // namespace pliant
