// SPDX-License-Identifier: MIT
// What the direct methods `newton` and `shake` share: they solve each component separately, skip
// whole ones, part coincident joints first, count, and leave the rest to sweeps. Joints always move
// by their inverse masses, as these methods are defined.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pliant/resolve/equations/bar_newton.hpp"
#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// The equations of each component, weighted by inverse mass.
class ComponentEquations {
 public:
  ComponentEquations(const Framework& framework, const Tolerance& tolerance);

  /// Whether some component is left to sweeps because of too many entries in its factors.
  bool entangled() const { return entangled_; }
  std::span<const BarEquations::Part> parts() const { return parts_; }
  BarEquations& equations() { return equations_; }

 private:
  BarEquations equations_;
  std::vector<BarEquations::Part> parts_;
  bool entangled_ = false;
};

/// Makes one component whole.
class PartSolver {
 public:
  virtual ~PartSolver() = default;
  /// Starts from `broken` (of the joints of the equations) and from equations.positions(), where
  /// coincident joints have been parted. Leaves its result there.
  virtual PartResult solve(BarEquations::Part part, std::span<const Vec3> broken,
                           const ResolveCall& call, const MayGoOn& may_go_on) = 0;
};

/// Makes a solver for the parts of these equations.
using MakePartSolver = std::unique_ptr<PartSolver> (*)(BarEquations& equations);

std::unique_ptr<Method> make_direct_method(const Framework& framework,
                                           const ResolveOptions& options, MakePartSolver make);

}  // namespace pliant
