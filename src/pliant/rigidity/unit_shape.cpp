// SPDX-License-Identifier: MIT
#include "pliant/rigidity/unit_shape.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/math/best_fit.hpp"

namespace pliant {
namespace {

/// Atoms have up to a dozen neighbours; eigenvectors take the third power of it.
constexpr std::size_t most_scaled_joints = 16;

/// Places the joints of one complete unit after another.
class Scaling {
 public:
  Scaling(const Framework& framework, const Tolerance& tolerance)
      : framework_(framework), tolerance_(tolerance) {}

  /// False if a bar is missing or no shape has these lengths.
  bool place(std::span<const Joint> joints, std::span<Vec3> points) {
    n_ = joints.size();
    if (n_ > most_scaled_joints || !gather(joints)) return false;
    centre();
    vectors_.resize(n_ * n_);
    find_eigenvectors(gram_, vectors_, n_);
    take_three(points);
    return fits(points);
  }

 private:
  bool gather(std::span<const Joint> joints) {
    rests_.assign(n_ * n_, 0.0);
    std::size_t found = 0;
    for (std::size_t i = 0; i < n_; ++i)
      for (const Incidence& at : framework_.neighbours(joints[i])) {
        const auto place = std::lower_bound(joints.begin(), joints.end(), at.joint);
        if (place == joints.end() || *place != at.joint) continue;
        rests_[i * n_ + std::size_t(place - joints.begin())] = framework_.rest_lengths()[at.bar];
        ++found;
      }
    return found == n_ * (n_ - 1);
  }

  /// Products of the places from the centroid: squares with the means of rows and columns removed.
  void centre() {
    gram_.resize(n_ * n_);
    std::vector<double> means(n_, 0.0);
    double mean = 0.0;
    for (std::size_t i = 0; i < n_; ++i) {
      for (std::size_t j = 0; j < n_; ++j) means[i] += square(i, j) / double(n_);
      mean += means[i] / double(n_);
    }
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j)
        gram_[i * n_ + j] = -0.5 * (square(i, j) - means[i] - means[j] + mean);
  }

  double square(std::size_t i, std::size_t j) const {
    return rests_[i * n_ + j] * rests_[i * n_ + j];
  }

  void take_three(std::span<Vec3> points) {
    std::vector<std::size_t> order(n_);
    for (std::size_t k = 0; k < n_; ++k) order[k] = k;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return gram_[a * n_ + a] > gram_[b * n_ + b];
    });
    const auto coordinate = [&](std::size_t joint, std::size_t k) {
      const double value = gram_[order[k] * n_ + order[k]];
      return value > 0.0 ? std::sqrt(value) * vectors_[joint * n_ + order[k]] : 0.0;
    };
    for (std::size_t i = 0; i < n_; ++i)
      points[i] = {coordinate(i, 0), coordinate(i, 1), coordinate(i, 2)};
    const Vec3 first = points[0];
    for (Vec3& point : points) point -= first;
  }

  bool fits(std::span<const Vec3> points) const {
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const double rest = rests_[i * n_ + j];
        // Rounding may be all that is wrong; the pass measures again.
        const double allowed = std::max(tolerance_.of(rest), 1e-12 * rest);
        if (!(std::abs(residual(points[i], points[j], rest)) <= allowed)) return false;
      }
    return true;
  }

  const Framework& framework_;
  Tolerance tolerance_;
  std::size_t n_ = 0;
  std::vector<double> rests_, gram_, vectors_;
};

}  // namespace

double rod_length(const Framework& framework, Joint a, Joint b) {
  for (const Incidence& at : framework.neighbours(a))
    if (at.joint == b) return framework.rest_lengths()[at.bar];
  return 0.0;
}

std::span<const Vec3> points_of(const Framework& framework, const UnitSet& set,
                                const UnitShapes& shapes, std::size_t unit,
                                std::vector<Vec3>& room) {
  const auto joints = set.at(unit);
  if (!shapes.points.empty())
    return std::span(shapes.points).subspan(set.begin_of(unit), joints.size());
  const auto drawn = framework.drawn();
  room.assign(joints.size(), {});
  if (joints.size() == 2)
    room[1].x = rod_length(framework, joints[0], joints[1]);
  else
    for (std::size_t k = 0; k < joints.size(); ++k) room[k] = drawn[joints[k]] - drawn[joints[0]];
  return room;
}

UnitShapes find_unit_shapes(const Framework& framework, const UnitSet& set,
                            const Tolerance& tolerance) {
  const bool is_drawn = !framework.drawn().empty();
  UnitShapes shapes{{}, std::vector<Vec3>(is_drawn ? 0 : set.things().size())};
  shapes.kinds.reserve(set.size());
  Scaling scaling(framework, tolerance);
  for (std::size_t unit = 0; unit < set.size(); ++unit) {
    const auto joints = set.at(unit);
    if (joints.size() == 2 || is_drawn) {
      shapes.kinds.push_back(joints.size() == 2 ? ShapeKind::rod : ShapeKind::drawn);
      if (!is_drawn)
        shapes.points[set.begin_of(unit) + 1].x = rod_length(framework, joints[0], joints[1]);
    } else {
      const auto points = std::span(shapes.points).subspan(set.begin_of(unit), joints.size());
      shapes.kinds.push_back(scaling.place(joints, points) ? ShapeKind::lengths
                                                           : ShapeKind::unknown);
    }
  }
  return shapes;
}

}  // namespace pliant
