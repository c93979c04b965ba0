// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/shape_keeper.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "pliant/resolve/bodies/froda.hpp"
#include "pliant/resolve/equations/kept_shapes.hpp"
#include "pliant/resolve/newton/newton.hpp"
#include "pliant/resolve/shake/shake.hpp"

namespace pliant {
namespace {

/// Units that share joints may bend each other once more.
constexpr int most_fits = 3;
/// Sweeps of `froda` in all.
constexpr std::int64_t most_sweeps = 20;

class ShapeKeeper final : public Method {
 public:
  ShapeKeeper(const Framework& framework, const ResolveOptions& options, KeptShapes shapes,
              std::unique_ptr<Method> method)
      : framework_(framework),
        options_(options),
        shapes_(std::move(shapes)),
        method_(std::move(method)) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    pushed_.assign(call.positions.begin(), call.positions.end());
    const Stop stop = method_->resolve(call, summary);
    if (stop != Stop::converged) return stop;
    bool is_bent = find_bent(call);
    for (int round = 0; round < most_fits && is_bent; ++round) {
      if (summary.sweeps >= options_.max_sweeps || !straighten(call, summary)) return stop;
      is_bent = find_bent(call);
    }
    if (is_bent) place_units(call, summary);
    return stop;
  }

 private:
  bool find_bent(const ResolveCall& call) {
    return shapes_.find_bent(call.positions, call.reference);
  }

  /// False, and all as it was, if the bars do not get whole again.
  bool straighten(const ResolveCall& call, ResolveSummary& summary) {
    whole_.assign(call.positions.begin(), call.positions.end());
    shapes_.straighten(call.positions);
    return keep_if_whole(call, *method_, summary);
  }

  /// Begins where the push left the joints; what was there is kept if that does no better.
  void place_units(const ResolveCall& call, ResolveSummary& summary) {
    whole_.assign(call.positions.begin(), call.positions.end());
    if (!froda_) {
      ResolveOptions options = options_;
      options.max_sweeps = std::min(options.max_sweeps, most_sweeps);
      froda_ = make_froda(framework_, {"froda", 0.5, true}, options);
    }
    std::copy(pushed_.begin(), pushed_.end(), call.positions.begin());
    if (keep_if_whole(call, *froda_, summary) && find_bent(call))
      std::copy(whole_.begin(), whole_.end(), call.positions.begin());
  }

  bool keep_if_whole(const ResolveCall& call, Method& method, ResolveSummary& summary) {
    ResolveSummary again;
    again.sweeps = again.projections = 0;
    const bool is_whole = method.resolve(call, again) == Stop::converged;
    summary.sweeps += again.sweeps;
    summary.projections += again.projections;
    if (!is_whole) std::copy(whole_.begin(), whole_.end(), call.positions.begin());
    return is_whole;
  }

  const Framework& framework_;
  ResolveOptions options_;
  KeptShapes shapes_;
  std::unique_ptr<Method> method_;
  std::unique_ptr<Method> froda_;  ///< null until it is needed
  std::vector<Vec3> pushed_, whole_;
};

std::unique_ptr<Method> keep_shapes(const Framework& framework, const ResolveOptions& options,
                                    std::unique_ptr<Method> method) {
  KeptShapes shapes(framework, options.tolerance);
  if (shapes.empty()) return method;
  return std::make_unique<ShapeKeeper>(framework, options, std::move(shapes), std::move(method));
}

}  // namespace

std::unique_ptr<Method> make_newton_in_shape(const Framework& framework, const Technique& technique,
                                             const ResolveOptions& options) {
  return keep_shapes(framework, options, make_newton(framework, technique, options));
}

std::unique_ptr<Method> make_shake_in_shape(const Framework& framework, const Technique& technique,
                                            const ResolveOptions& options) {
  return keep_shapes(framework, options, make_shake(framework, technique, options));
}

}  // namespace pliant
