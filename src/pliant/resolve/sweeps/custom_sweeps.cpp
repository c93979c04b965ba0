// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/custom_sweeps.hpp"

#include <algorithm>
#include <vector>

#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {
namespace {

/// The loop around the sweep: it alone decides when to end, so that no sweep is believed.
class CustomSweeps final : public Method {
 public:
  CustomSweeps(const Framework& framework, const Technique& technique,
               const ResolveOptions& options)
      : framework_(framework), sweep_(technique.sweep), options_(options) {
    if (framework.sterics() != nullptr) contacts_ = std::make_unique<NeighbourList>(framework);
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    before_.assign(call.positions.begin(), call.positions.end());
    try {
      return sweep_until_whole(call, summary);
    } catch (...) {
      std::copy(before_.begin(), before_.end(), call.positions.begin());
      throw;
    }
  }

 private:
  Stop sweep_until_whole(const ResolveCall& call, ResolveSummary& summary) {
    for (;;) {
      if (!std::all_of(call.positions.begin(), call.positions.end(), is_finite))
        return Stop::not_finite;
      const ResidualSummary found =
          measure(framework_, call.positions, options_.tolerance, call.limits_off, contacts_.get());
      if (!found.finite) return Stop::not_finite;
      if (found.within) return Stop::converged;
      if (summary.sweeps == options_.max_sweeps) return Stop::max_sweeps;
      if (summary.sweeps > 0 && options_.should_stop && options_.should_stop())
        return Stop::stopped_by_caller;
      sweep_(call.positions, summary.sweeps);
      put_back_what_stays(call.positions);
      ++summary.sweeps;
      summary.projections += static_cast<std::int64_t>(framework_.bar_count());
    }
  }

  /// Pinned joints, and the height of what lies in a plane.
  void put_back_what_stays(std::span<Vec3> positions) const {
    if (!framework_.has_pinned_joints() && !framework_.is_planar()) return;
    for (Joint joint = 0; joint < positions.size(); ++joint) {
      if (framework_.is_pinned(joint)) positions[joint] = before_[joint];
      if (framework_.is_planar()) positions[joint].z = before_[joint].z;
    }
  }

  const Framework& framework_;
  CustomSweep sweep_;
  ResolveOptions options_;
  std::unique_ptr<NeighbourList> contacts_;  ///< null: no sterics
  std::vector<Vec3> before_;                 ///< where the resolve began
};

}  // namespace

std::unique_ptr<Method> make_custom_sweeps(const Framework& framework, const Technique& technique,
                                           const ResolveOptions& options) {
  return std::make_unique<CustomSweeps>(framework, technique, options);
}

}  // namespace pliant
