// SPDX-License-Identifier: MIT
// What L-BFGS knows of the curvature: its last steps (J. Nocedal, Math. Comput. 35 (1980) 773).
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

namespace points {

double inner(const std::vector<Vec3>& a, const std::vector<Vec3>& b);
void add(double factor, const std::vector<Vec3>& from, std::vector<Vec3>& to);
std::vector<Vec3> difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

}  // namespace points

class LbfgsMemory {
 public:
  /// Keeps the last `most` steps.
  explicit LbfgsMemory(std::size_t most) : most_(most) {}

  /// A step and how it changed the gradient, unless their product is `least` or less: without
  /// positive curvature the estimate would no longer be that of a minimum.
  void keep(std::vector<Vec3> step, std::vector<Vec3> change, double least);

  /// Minus the estimate of the inverse Hessian times the gradient, by two loops over the steps.
  /// `first` is its scale where no step is known.
  std::vector<Vec3> direction(const std::vector<Vec3>& gradient, double first) const;

  void forget() { kept_.clear(); }
  bool empty() const { return kept_.empty(); }

 private:
  struct Kept {
    std::vector<Vec3> step, change;
    double curvature;
  };
  std::size_t most_;
  std::deque<Kept> kept_;  ///< the latest last
};

}  // namespace pliant
