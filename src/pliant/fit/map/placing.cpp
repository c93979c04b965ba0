// SPDX-License-Identifier: MIT
#include "pliant/fit/map/placing.hpp"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/fit/map/blurred.hpp"
#include "pliant/fit/map/spread_rotations.hpp"

namespace pliant {
namespace {

constexpr std::size_t rotation_count = 2000, most_centers = 30;
constexpr std::size_t most_searched = 300, most_climbed = 2000;  ///< atoms
constexpr std::size_t coarse_climbs = 40, fine_climbs = 8;

/// A rigid body about its center: weights have the sum 1.
class Body {
 public:
  Body(std::span<const Vec3> positions, std::span<const double> weights, std::size_t most) {
    const std::size_t stride = 1 + (positions.size() - 1) / most;
    double sum = 0.0;
    for (std::size_t k = 0; k < positions.size(); k += stride) {
      arms_.push_back(positions[k]);
      weights_.push_back(weights[k]);
      sum += weights[k];
    }
    for (double& weight : weights_) weight /= sum;
    for (std::size_t k = 0; k < arms_.size(); ++k) center_ += weights_[k] * arms_[k];
    double squares = 0.0;
    for (std::size_t k = 0; k < arms_.size(); ++k) {
      arms_[k] -= center_;
      squares += weights_[k] * norm_squared(arms_[k]);
    }
    size_ = std::sqrt(squares);
  }

  /// Radius of gyration, Angstrom.
  double size() const { return size_; }

  /// The motion whose turn is about the center, which it brings to `place`.
  RigidMotion motion_to(const Rotation& turn, Vec3 place) const {
    return {turn, place - turn(center_)};
  }

  double density(const DensityMap& map, const Rotation& turn, Vec3 place) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < arms_.size(); ++k)
      sum += weights_[k] * map.at(turn(arms_[k]) + place).value;
    return sum;
  }

  Placing climb(const DensityMap& map, Rotation turn, Vec3 place) const;
  Placing climb(const DensityMap& map, const RigidMotion& start) const {
    return climb(map, start.rotation, start(center_));
  }

 private:
  /// The density, and how it grows with a shift and a turn.
  struct Slope {
    double density = 0.0;
    Vec3 force, torque;
  };
  Slope slope(const DensityMap& map, const Rotation& turn, Vec3 place) const;

  std::vector<Vec3> arms_;
  std::vector<double> weights_;
  Vec3 center_;
  double size_ = 0.0;
};

Body::Slope Body::slope(const DensityMap& map, const Rotation& turn, Vec3 place) const {
  Slope out;
  for (std::size_t k = 0; k < arms_.size(); ++k) {
    const Vec3 arm = turn(arms_[k]);
    const DensityAt found = map.at(arm + place);
    const Vec3 pull = weights_[k] * found.gradient;
    out.density += weights_[k] * found.value;
    out.force += pull;
    out.torque += cross(arm, pull);
  }
  return out;
}

/// Steepest ascent whose steps grow while they succeed and are halved when they do not.
Placing Body::climb(const DensityMap& map, Rotation turn, Vec3 place) const {
  constexpr double longest = 2.0, shortest = 0.003;  // Angstrom
  Slope here = slope(map, turn, place);
  double step = longest;
  for (int steps = 0; steps < 500 && step > shortest; ++steps) {
    const Vec3 spin = (1.0 / (size_ * size_)) * here.torque;
    const double length = norm(here.force) + size_ * norm(spin);
    if (!(length > 0.0)) break;
    const Vec3 turned = (step / length) * spin;
    const double angle = norm(turned);
    const Rotation next_turn =
        angle > 0.0 ? product(turn_about((1.0 / angle) * turned, 0.5 * angle), turn) : turn;
    const Vec3 next_place = place + (step / length) * here.force;
    const Slope next = slope(map, next_turn, next_place);
    step = next.density > here.density ? std::min(1.5 * step, longest) : 0.5 * step;
    if (next.density > here.density)
      std::tie(here, turn, place) = std::tie(next, next_turn, next_place);
  }
  return {motion_to(turn, place), here.density};
}

/// The center of what is above the mean by a deviation or more.
Vec3 center_of(const DensityMap& map) {
  const MapStatistics found = map.statistics();
  const double floor = found.mean + found.deviation;
  Vec3 moment;
  double sum = 0.0;
  for (std::size_t point = 0; point < map.values().size(); ++point) {
    const double excess = map.values()[point] - floor;
    if (excess <= 0.0) continue;
    moment += excess * place_of(map.grid(), point);
    sum += excess;
  }
  return sum > 0.0 ? (1.0 / sum) * moment : place_of(map.grid(), map.grid().size() / 2);
}

/// Points whose numbers along each axis are a stride apart, and whose value is above half of the
/// greatest.
std::vector<Vec3> dense_places(const DensityMap& map, std::size_t stride, double greatest) {
  const MapGrid& grid = map.grid();
  std::vector<Vec3> out;
  for (std::size_t i = stride / 2; i < grid.count[0]; i += stride)
    for (std::size_t j = stride / 2; j < grid.count[1]; j += stride)
      for (std::size_t k = stride / 2; k < grid.count[2]; k += stride) {
        const std::size_t point = grid.points().at(i, j, k);
        if (map.values()[point] > 0.5 * greatest) out.push_back(place_of(grid, point));
      }
  return out;
}

/// Where the center of a molecule is tried: the center of density, and places in dense parts, about
/// `apart` (Angstrom) from each other where these are not too many.
std::vector<Vec3> tried_centers(const DensityMap& map, double apart) {
  const std::array<double, 3> spacing = map.grid().spacing();
  const double greatest = map.statistics().greatest;
  auto stride = static_cast<std::size_t>(
      std::max(1.0, apart / *std::min_element(spacing.begin(), spacing.end())));
  std::vector<Vec3> centers = dense_places(map, stride, greatest);
  while (centers.size() > most_centers)
    centers = dense_places(map, stride += 1 + stride / 8, greatest);
  centers.insert(centers.begin(), center_of(map));
  return centers;
}

/// A place and a turn of a body, before it climbs.
struct Trial {
  double density;
  Rotation turn;
  Vec3 place;

  /// Whether both would climb to the same summit, as a rule: 25 degrees and 5 Angstrom.
  bool is_near(const Trial& other) const {
    const double trace =
        dot(turn.x, other.turn.x) + dot(turn.y, other.turn.y) + dot(turn.z, other.turn.z);
    return trace > 2.81 && distance(place, other.place) < 5.0;
  }
};

/// The `most` densest trials of which no two are near to each other.
std::vector<Trial> best_trials(std::vector<Trial> trials, std::size_t most) {
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.density > b.density; });
  std::vector<Trial> best;
  for (const Trial& trial : trials) {
    if (best.size() == most) break;
    if (std::none_of(best.begin(), best.end(),
                     [&](const Trial& other) { return trial.is_near(other); }))
      best.push_back(trial);
  }
  return best;
}

std::vector<Trial> searched(const DensityMap& coarse, const Body& body) {
  const std::vector<Rotation> turns = spread_rotations(rotation_count);
  std::vector<Trial> trials;
  for (const Vec3 place : tried_centers(coarse, std::max(0.7 * body.size(), 4.0)))
    for (const Rotation& turn : turns)
      trials.push_back({body.density(coarse, turn, place), turn, place});
  return best_trials(std::move(trials), coarse_climbs);
}

void sort_by_density(std::vector<Placing>& placings) {
  std::stable_sort(placings.begin(), placings.end(),
                   [](const Placing& a, const Placing& b) { return a.density > b.density; });
}

void check_body(std::span<const Vec3> positions, std::span<const double> weights) {
  if (positions.size() < 3)
    throw InputError("positions: expected three or more, found " +
                     std::to_string(positions.size()));
  if (weights.size() != positions.size())
    throw InputError("weights: expected " + std::to_string(positions.size()) +
                     ", one for each position, found " + std::to_string(weights.size()));
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (!is_finite(positions[k]) || !(weights[k] > 0.0 && weights[k] < 1e9))
      throw InputError("positions: row " + std::to_string(k) +
                       " is not finite, or its weight is not above 0");
}

}  // namespace

Placing place_in_map(const DensityMap& map, std::span<const Vec3> positions,
                     std::span<const double> weights, double resolution) {
  check_body(positions, weights);
  const std::vector<DensityMap> maps = density_pyramid(map, resolution);
  const Body sparse(positions, weights, most_searched), body(positions, weights, most_climbed);
  std::vector<Placing> found;
  for (const Trial& trial : searched(maps[0], sparse))
    found.push_back(sparse.climb(maps[0], trial.turn, trial.place));
  sort_by_density(found);
  found.resize(std::min(found.size(), fine_climbs));
  for (Placing& one : found) one = body.climb(maps[1], one.motion);
  sort_by_density(found);
  return found.front();
}

Placing climb_in_map(const DensityMap& map, std::span<const Vec3> positions,
                     std::span<const double> weights, const RigidMotion& start) {
  check_body(positions, weights);
  return Body(positions, weights, most_climbed).climb(map, start);
}

}  // namespace pliant
