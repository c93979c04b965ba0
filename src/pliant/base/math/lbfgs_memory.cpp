// SPDX-License-Identifier: MIT
#include "pliant/base/math/lbfgs_memory.hpp"

#include <utility>

namespace pliant {

double points::inner(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
  return sum;
}

void points::add(double factor, const std::vector<Vec3>& from, std::vector<Vec3>& to) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += factor * from[k];
}

std::vector<Vec3> points::difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  std::vector<Vec3> out = a;
  add(-1.0, b, out);
  return out;
}

void LbfgsMemory::keep(std::vector<Vec3> step, std::vector<Vec3> change, double least) {
  const double curvature = points::inner(step, change);
  if (!(curvature > least)) return;
  kept_.push_back({std::move(step), std::move(change), curvature});
  if (kept_.size() > most_) kept_.pop_front();
}

std::vector<Vec3> LbfgsMemory::direction(const std::vector<Vec3>& gradient, double first) const {
  std::vector<Vec3> out = gradient;
  std::vector<double> share(kept_.size());
  for (std::size_t k = kept_.size(); k-- > 0;) {
    share[k] = points::inner(kept_[k].step, out) / kept_[k].curvature;
    points::add(-share[k], kept_[k].change, out);
  }
  const double scale =
      empty() ? first
              : kept_.back().curvature / points::inner(kept_.back().change, kept_.back().change);
  for (Vec3& v : out) v *= -scale;
  for (std::size_t k = 0; k < kept_.size(); ++k)
    points::add(-share[k] - points::inner(kept_[k].change, out) / kept_[k].curvature, kept_[k].step,
                out);
  return out;
}

}  // namespace pliant
