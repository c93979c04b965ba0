// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/mass_centre.hpp"

#include <utility>
#include <vector>

#include "pliant/framework/graph.hpp"

namespace pliant {
namespace {

class MassCentreKept final : public Method {
 public:
  MassCentreKept(const Framework& framework, std::unique_ptr<Method> method)
      : inverse_masses_(framework.inverse_masses()),
        method_(std::move(method)),
        component_of_(find_components(framework).of_node) {
    for (Joint joint = 0; joint < component_of_.size(); ++joint) {
      const std::uint32_t component = component_of_[joint];
      if (component >= masses_.size()) masses_.resize(component + 1, 0.0);
      masses_[component] += 1.0 / inverse_masses_[joint];  // infinite if it is pinned
    }
    shifts_.resize(masses_.size());
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    before_.assign(call.positions.begin(), call.positions.end());
    const Stop stop = method_->resolve(call, summary);
    if (stop != Stop::not_finite) shift(call.positions);
    return stop;
  }

 private:
  void shift(std::span<Vec3> positions) {
    shifts_.assign(masses_.size(), {});
    for (Joint joint = 0; joint < positions.size(); ++joint) {
      const std::uint32_t component = component_of_[joint];
      const double share = 1.0 / (inverse_masses_[joint] * masses_[component]);
      if (is_free(component)) shifts_[component] += share * (before_[joint] - positions[joint]);
    }
    for (Joint joint = 0; joint < positions.size(); ++joint)
      positions[joint] += shifts_[component_of_[joint]];
  }

  bool is_free(std::uint32_t component) const { return std::isfinite(masses_[component]); }

  std::span<const double> inverse_masses_;
  std::unique_ptr<Method> method_;
  std::vector<std::uint32_t> component_of_;
  std::vector<double> masses_;  ///< of components (u); infinite if one of its joints is pinned
  std::vector<Vec3> shifts_, before_;
};

}  // namespace

std::unique_ptr<Method> keep_mass_centre(const Framework& framework,
                                         std::unique_ptr<Method> method) {
  return std::make_unique<MassCentreKept>(framework, std::move(method));
}

}  // namespace pliant
