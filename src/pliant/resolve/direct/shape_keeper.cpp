// SPDX-License-Identifier: MIT
#include "pliant/resolve/direct/shape_keeper.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "pliant/resolve/direct/kept_shapes.hpp"

namespace pliant {
namespace {

/// Units that share joints may bend each other once more.
constexpr int most_rounds = 6;

class ShapeKeeper final : public Method {
 public:
  ShapeKeeper(const ResolveOptions& options, KeptShapes shapes, std::unique_ptr<Method> method)
      : options_(options), shapes_(std::move(shapes)), method_(std::move(method)) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    const Stop stop = method_->resolve(call, summary);
    for (int round = 0; round < most_rounds; ++round) {
      if (stop != Stop::converged || summary.sweeps >= options_.max_sweeps) break;
      if (!shapes_.find_bent(call.positions, call.reference)) break;
      if (!straighten(call, summary)) break;
    }
    return stop;
  }

  bool looks_near() const override { return method_->looks_near(); }

 private:
  /// What was whole before is kept if the bars do not get whole again.
  bool straighten(const ResolveCall& call, ResolveSummary& summary) {
    whole_.assign(call.positions.begin(), call.positions.end());
    shapes_.straighten(call.positions);
    ResolveSummary again;
    again.sweeps = again.projections = 0;
    const bool is_whole = method_->resolve(call, again) == Stop::converged;
    summary.sweeps += again.sweeps;
    summary.projections += again.projections;
    if (!is_whole) std::copy(whole_.begin(), whole_.end(), call.positions.begin());
    return is_whole;
  }

  ResolveOptions options_;
  KeptShapes shapes_;
  std::unique_ptr<Method> method_;
  std::vector<Vec3> whole_;
};

}  // namespace

bool has_shapes_to_keep(const Framework& framework, const ResolveOptions& options) {
  return !KeptShapes(framework, options.tolerance).empty();
}

std::unique_ptr<Method> keep_shapes(const Framework& framework, const ResolveOptions& options,
                                    std::unique_ptr<Method> method) {
  KeptShapes shapes(framework, options.tolerance);
  if (shapes.empty()) return method;
  return std::make_unique<ShapeKeeper>(options, std::move(shapes), std::move(method));
}

}  // namespace pliant
