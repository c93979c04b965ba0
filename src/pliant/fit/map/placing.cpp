// SPDX-License-Identifier: MIT
#include "pliant/fit/map/placing.hpp"

#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/fit/map/blurred.hpp"
#include "pliant/fit/map/simulated.hpp"
#include "pliant/fit/map/spread_rotations.hpp"

namespace pliant {
namespace {

constexpr std::size_t rotation_count = 1000, most_centers = 60;
constexpr std::size_t most_searched = 150, most_climbed = 2000;  ///< points
constexpr std::size_t climbs_per_center = 6, fine_climbs = 30;
constexpr double last_step = 0.003;  ///< Angstrom

/// A place of a body's center, its turn about that, and the density there.
struct Trial {
  double density;
  Rotation turn;
  Vec3 place;

  /// Whether both lie below the same summit, as a rule: within 25 degrees and 5 Angstrom.
  bool is_near(const Trial& other) const {
    const double trace =
        dot(turn.x, other.turn.x) + dot(turn.y, other.turn.y) + dot(turn.z, other.turn.z);
    return trace > 2.81 && distance(place, other.place) < 5.0;
  }
};

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

  /// Lets density at `points`, where the body is not, count against it, as much as its own for it.
  void shun(std::span<const Vec3> points) {
    for (const Vec3 point : points) {
      arms_.push_back(point - center_);
      weights_.push_back(-1.0 / static_cast<double>(points.size()));
    }
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

  Trial climb(const DensityMap& map, Trial trial, double shortest) const;
  Trial polished(const DensityMap& map, Trial trial) const;
  Placing placing(const Trial& trial) const {
    return {motion_to(trial.turn, trial.place), trial.density};
  }
  Trial trial(const RigidMotion& motion) const { return {0.0, motion.rotation, motion(center_)}; }

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

/// Steepest ascent whose steps (Angstrom) grow while they succeed and are halved when they do not,
/// until they are shorter than `shortest`.
Trial Body::climb(const DensityMap& map, Trial trial, double shortest) const {
  constexpr double longest = 2.0;
  Slope here = slope(map, trial.turn, trial.place);
  double step = longest;
  for (int steps = 0; steps < 500 && step > shortest; ++steps) {
    const Vec3 spin = (1.0 / (size_ * size_)) * here.torque;
    const double length = norm(here.force) + size_ * norm(spin);
    if (!(length > 0.0)) break;
    const Vec3 turned = (step / length) * spin;
    const double angle = norm(turned);
    Trial next{0.0, trial.turn, trial.place + (step / length) * here.force};
    if (angle > 0.0)
      next.turn = product(turn_about((1.0 / angle) * turned, 0.5 * angle), trial.turn);
    const Slope there = slope(map, next.turn, next.place);
    const bool is_higher = there.density > here.density;
    step = is_higher ? std::min(1.5 * step, longest) : 0.5 * step;
    if (is_higher) std::tie(here, trial) = std::tie(there, next);
  }
  trial.density = here.density;
  return trial;
}

/// Tries steps both ways along and about each axis, halved where none goes up: the slope changes
/// from one cell of the map to the next, and on an edge between them it leads nowhere.
Trial Body::polished(const DensityMap& map, Trial trial) const {
  double step = 0.5;
  for (int rounds = 0; rounds < 200 && step > last_step; ++rounds) {
    bool has_risen = false;
    for (const double way : {step, -step})
      for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const Rotation turn = turn_about(axis, 0.5 * way / std::max(size_, 1.0));
        for (Trial next : {Trial{0.0, trial.turn, trial.place + way * axis},
                           Trial{0.0, product(turn, trial.turn), trial.place}}) {
          next.density = density(map, next.turn, next.place);
          if (next.density <= trial.density) continue;
          trial = next;
          has_risen = true;
        }
      }
    if (!has_risen) step *= 0.5;
  }
  return trial;
}

/// Points, at most `most`, about a resolution away from the nearest position: where a molecule
/// ends. Without them each molecule would be drawn into the midst of the largest one.
std::vector<Vec3> shell_of(std::span<const Vec3> positions, double resolution, std::size_t most) {
  const MapGrid grid = grid_around(positions, 2.0 * resolution, 0.5 * resolution);
  const PlacesOnGrid places(grid);
  Mask shell(grid.size(), 0);
  for (const auto& [radius, value] : {std::pair{1.25, 1}, std::pair{0.75, 0}})
    for (const Vec3 position : positions)
      for_each_point_near(grid, places, position, radius * resolution,
                          [&shell, value = value](std::size_t point, double) {
                            shell[point] = static_cast<std::uint8_t>(value);
                          });
  std::vector<Vec3> all, some;
  for (std::size_t point = 0; point < shell.size(); ++point)
    if (shell[point] != 0) all.push_back(place_of(grid, point));
  for (std::size_t k = 0; k < all.size(); k += 1 + (all.size() - 1) / most) some.push_back(all[k]);
  return some;
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

/// Points whose numbers along each axis are a stride apart, and whose value is above 0.3 of the
/// greatest.
std::vector<Vec3> dense_places(const DensityMap& map, std::size_t stride, double greatest) {
  const MapGrid& grid = map.grid();
  std::vector<Vec3> out;
  for (std::size_t i = stride / 2; i < grid.count[0]; i += stride)
    for (std::size_t j = stride / 2; j < grid.count[1]; j += stride)
      for (std::size_t k = stride / 2; k < grid.count[2]; k += stride) {
        const std::size_t point = grid.points().at(i, j, k);
        if (map.values()[point] > 0.3 * greatest) out.push_back(place_of(grid, point));
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

/// The densest trials about each center, so that none is left out for others in denser parts.
std::vector<Trial> searched(const DensityMap& coarse, const Body& body) {
  const std::vector<Rotation> turns = spread_rotations(rotation_count);
  std::vector<Trial> found;
  for (const Vec3 place : tried_centers(coarse, std::max(0.7 * body.size(), 4.0))) {
    std::vector<Trial> trials;
    for (const Rotation& turn : turns)
      trials.push_back({body.density(coarse, turn, place), turn, place});
    trials = best_trials(std::move(trials), climbs_per_center);
    found.insert(found.end(), trials.begin(), trials.end());
  }
  return found;
}

/// The summits in a map that trials climb to, densest first, each once.
std::vector<Trial> summits(const DensityMap& map, const Body& body, std::vector<Trial> trials,
                           std::size_t most) {
  for (Trial& trial : trials) trial = body.climb(map, trial, 0.1);
  return best_trials(std::move(trials), most);
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

std::vector<Placing> place_in_map(const DensityMap& map, std::span<const Vec3> positions,
                                  std::span<const double> weights, double resolution,
                                  std::size_t most) {
  check_body(positions, weights);
  const std::vector<DensityMap> maps = density_pyramid(map, resolution);
  const Body body(positions, weights, most_climbed);
  Body searching(positions, weights, most_searched);
  searching.shun(shell_of(positions, resolution, most_searched));
  std::vector<Trial> found = summits(maps[0], searching, searched(maps[0], searching), fine_climbs);
  found = summits(maps[1], searching, std::move(found), most);
  std::vector<Placing> out;
  for (const Trial& trial : found) {
    const Trial start = body.trial(searching.placing(trial).motion);
    out.push_back(body.placing(body.polished(maps[1], body.climb(maps[1], start, 0.1))));
  }
  return out;
}

}  // namespace pliant
