// SPDX-License-Identifier: MIT
// What the direct methods `newton` and `shake` share: they take each component alone, leave whole
// ones untouched, part coincident joints first, count, and hand what they cannot finish to sweeps.
// Joints always move by their inverse masses: that is what these methods are.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "pliant/resolve/direct/bar_newton.hpp"
#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// The equations of each component, weighted by inverse mass.
class ComponentEquations {
 public:
  ComponentEquations(const Framework& framework, const Tolerance& tolerance);

  /// Some component is left to sweeps: its bars are too entangled.
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
  /// Begins at `broken` (of the joints of the equations); joints that coincided there have parted
  /// at equations.positions(). Leaves its answer there.
  virtual PartResult solve(BarEquations::Part part, std::span<const Vec3> broken,
                           const ResolveCall& call, const MayGoOn& may_go_on) = 0;
};

/// A solver for the parts of these equations.
using MakePartSolver = std::unique_ptr<PartSolver> (*)(BarEquations& equations);

std::unique_ptr<Method> make_direct_method(const Framework& framework,
                                           const ResolveOptions& options, MakePartSolver make);

}  // namespace pliant
