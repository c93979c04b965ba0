// SPDX-License-Identifier: MIT
#include "pliant/resolve/newton/newton.hpp"

#include "pliant/resolve/equations/direct_method.hpp"
#include "pliant/resolve/newton/nearest_point.hpp"

namespace pliant {
namespace {

class NewtonSolver final : public PartSolver {
 public:
  explicit NewtonSolver(BarEquations& equations) : nearest_(equations) {}

  PartResult solve(BarEquations::Part part, std::span<const Vec3> broken, const ResolveCall& call,
                   const MayGoOn& may_go_on) override {
    return nearest_.find(part, broken, call.key, may_go_on);
  }

 private:
  NearestPoint nearest_;
};

}  // namespace

std::unique_ptr<Method> make_newton(const Framework& framework, const Technique&,
                                    const ResolveOptions& options) {
  return make_direct_method(framework, options, [](BarEquations& equations) {
    return std::unique_ptr<PartSolver>(std::make_unique<NewtonSolver>(equations));
  });
}

}  // namespace pliant
