// SPDX-License-Identifier: MIT
#include "pliant/resolve/units/templates.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/sweeps/anderson.hpp"
#include "pliant/resolve/sweeps/limit_sweep.hpp"
#include "pliant/rigidity/place_unit.hpp"
#include "pliant/rigidity/unit_graph.hpp"
#include "pliant/rigidity/unit_shape.hpp"

namespace pliant {
namespace {

/// Shapes must have their bars' lengths by this share of the tolerance, or they never agree.
constexpr double share_for_shapes = 0.1;
/// A pinned joint counts for so many in fits: its templates come to it, since it stays.
constexpr double weight_of_pinned = 1e3;

/// Goes further than each sweep by Anderson mixing, as far as that helps.
class Acceleration {
 public:
  void begin(std::span<const Vec3> positions) {
    before_.assign(positions.begin(), positions.end());
    mixing_.restart();
    extrapolated_ = false;
    path_ = 0.0;
  }

  /// `positions` are those after a sweep. What led astray is taken back.
  void mix(std::span<Vec3> positions) {
    const double step = find_step(positions);
    if (extrapolated_ && !(step <= 2.0 * last_step_)) {  // also when it is not a number
      std::ranges::copy(last_sweep_, positions.begin());
      begin(positions);
      return;
    }
    last_sweep_.assign(positions.begin(), positions.end());
    last_step_ = step;
    path_ += step;
    extrapolated_ = mixing_.mix(step_, last_sweep_);
    if (extrapolated_) go_on(positions);
    before_.assign(positions.begin(), positions.end());
  }

 private:
  /// What the sweep did, and how far that is.
  double find_step(std::span<const Vec3> positions) {
    step_.resize(positions.size());
    double squared = 0.0;
    for (std::size_t k = 0; k < positions.size(); ++k) {
      step_[k] = positions[k] - before_[k];
      squared += norm_squared(step_[k]);
    }
    return std::sqrt(squared);
  }

  /// An extrapolation (in step_) may double the way that the joints have come, not more.
  void go_on(std::span<Vec3> positions) {
    double squared = 0.0;
    for (std::size_t k = 0; k < positions.size(); ++k)
      squared += norm_squared(step_[k] - positions[k]);
    const double length = std::sqrt(squared);
    const double share = length > path_ ? path_ / length : 1.0;
    for (std::size_t k = 0; k < positions.size(); ++k)
      positions[k] += share * (step_[k] - positions[k]);
    path_ += share * length;
  }

  AndersonMixing mixing_;
  std::vector<Vec3> before_;      ///< where the sweep began
  std::vector<Vec3> last_sweep_;  ///< after the sweep before the extrapolation
  std::vector<Vec3> step_;        ///< what a sweep did, then where to go on
  double last_step_ = 0.0, path_ = 0.0;
  bool extrapolated_ = false;
};

class Templates final : public Method {
 public:
  Templates(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        options_(options),
        keeps_centre_(technique.mass_weighted && !framework.has_pinned_joints()),
        limits_(make_limit_sweep(framework, technique.mass_weighted, options.tolerance)),
        counts_(framework.joint_count(), 0.0),
        weights_(framework.joint_count(), 1.0),
        sums_(framework.joint_count()) {
    if (framework.sterics() != nullptr) contacts_ = std::make_unique<NeighbourList>(framework);
    find_templates();
    weigh(technique.mass_weighted);
    for (std::size_t unit = 0; unit < units_.size(); ++unit) centre(unit);
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    const Vec3 before = keeps_centre_ ? centre_of_mass(call.positions) : Vec3{};
    const Stop stop = sweep_until_whole(call, summary);
    if (!keeps_centre_ || stop == Stop::not_finite || summary.sweeps == 0) return stop;
    const Vec3 by = before - centre_of_mass(call.positions);  // rounding, which mixing multiplies
    for (Vec3& x : call.positions) x += by;
    return stop;
  }

 private:
  Stop sweep_until_whole(const ResolveCall& call, ResolveSummary& summary) {
    if (limits_) limits_->begin(call.limits_off);
    acceleration_.begin(call.positions);
    for (;;) {
      const ResidualSummary found =
          measure(framework_, call.positions, options_.tolerance, call.limits_off, contacts_.get());
      if (!found.finite) return Stop::not_finite;
      if (found.within) return Stop::converged;
      if (summary.sweeps == options_.max_sweeps) return Stop::max_sweeps;
      if (summary.sweeps > 0 && options_.should_stop && options_.should_stop())
        return Stop::stopped_by_caller;
      sweep(call.positions, call.key);
      ++summary.sweeps;
      summary.projections += static_cast<std::int64_t>(framework_.bar_count());
      if (limits_) summary.projections += limits_->sweep(call.positions, call.key);
      acceleration_.mix(call.positions);
    }
  }

  Vec3 centre_of_mass(std::span<const Vec3> positions) const {
    Vec3 sum;
    double masses = 0.0;
    for (Joint joint = 0; joint < positions.size(); ++joint) {
      const double mass = 1.0 / framework_.inverse_masses()[joint];
      sum += mass * positions[joint];
      masses += mass;
    }
    return (1.0 / masses) * sum;
  }

  void find_templates() {
    UnitSet set = find_units(framework_);
    if (!framework_.drawn().empty()) set = merge_rigid_loops(framework_, std::move(set)).set;
    const UnitShapes shapes = find_unit_shapes(framework_, set, options_.tolerance);
    const std::vector<std::uint8_t> contradicted = find_contradicted(set, shapes);
    std::vector<Vec3> room;
    for (std::size_t unit = 0; unit < set.size(); ++unit) {
      if (!has_shape(shapes.kinds[unit]) || contradicted[unit] != 0) continue;
      const auto points = points_of(framework_, set, shapes, unit, room);
      units_.add(set.at(unit));
      points_.insert(points_.end(), points.begin(), points.end());
      mirrors_.push_back(shapes.kinds[unit] == ShapeKind::lengths);
    }
    find_rods();
  }

  static bool has_shape(ShapeKind kind) {
    return kind == ShapeKind::drawn || kind == ShapeKind::lengths;
  }

  /// Units (1) whose shape gives a bar another length than its rest length.
  std::vector<std::uint8_t> find_contradicted(const UnitSet& set, const UnitShapes& shapes) const {
    const UnitsOfJoints at(set, framework_.joint_count());
    std::vector<std::uint8_t> contradicted(set.size(), 0);
    std::vector<std::uint32_t> both;
    for (BarIndex bar = 0; bar < framework_.bar_count(); ++bar) {
      const auto [a, b] = framework_.bars()[bar];
      const double rest = framework_.rest_lengths()[bar];
      at.common(a, b, both);
      for (std::uint32_t unit : both) {
        if (!has_shape(shapes.kinds[unit])) continue;
        const bool drawn = shapes.kinds[unit] == ShapeKind::drawn;
        const auto place = [&](Joint joint) {
          if (drawn) return framework_.drawn()[joint];
          const auto found = std::ranges::lower_bound(set.at(unit), joint);
          return shapes
              .points[set.begin_of(unit) + static_cast<std::size_t>(found - set.at(unit).begin())];
        };
        const double off = std::abs(distance(place(a), place(b)) - rest);
        if (!(off <= share_for_shapes * options_.tolerance.of(rest))) contradicted[unit] = 1;
      }
    }
    return contradicted;
  }

  /// Bars that no template holds.
  void find_rods() {
    const UnitsOfJoints at(units_, framework_.joint_count());
    std::vector<std::uint32_t> both;
    for (BarIndex bar = 0; bar < framework_.bar_count(); ++bar) {
      at.common(framework_.bars()[bar].a, framework_.bars()[bar].b, both);
      if (both.empty()) rods_.push_back(bar);
    }
  }

  /// Counts the templates of each joint, and divides its mass among them.
  void weigh(bool mass_weighted) {
    for (Joint joint : units_.things()) counts_[joint] += 1.0;
    for (BarIndex bar : rods_) {
      counts_[framework_.bars()[bar].a] += 1.0;
      counts_[framework_.bars()[bar].b] += 1.0;
    }
    for (Joint joint = 0; joint < weights_.size(); ++joint) {
      if (framework_.is_pinned(joint))
        weights_[joint] = weight_of_pinned;
      else if (mass_weighted)
        weights_[joint] = 1.0 / framework_.inverse_masses()[joint];
      if (counts_[joint] > 0.0) weights_[joint] /= counts_[joint];
    }
  }

  std::span<Vec3> points_at(std::size_t unit) {
    return std::span(points_).subspan(units_.begin_of(unit), units_.at(unit).size());
  }

  /// Takes points from the centre of the weights.
  void centre(std::size_t unit) {
    const Vec3 middle = middle_of(units_.at(unit), points_at(unit), [](auto, auto k) { return k; });
    for (Vec3& point : points_at(unit)) point -= middle;
  }

  template <class Place>
  Vec3 middle_of(std::span<const Joint> joints, std::span<const Vec3> places, Place place) const {
    Vec3 sum;
    double weights = 0.0;
    for (std::size_t k = 0; k < joints.size(); ++k) {
      sum += weights_[joints[k]] * places[place(joints[k], k)];
      weights += weights_[joints[k]];
    }
    return (1.0 / weights) * sum;
  }

  void sweep(std::span<Vec3> positions, const RandomKey& key) {
    std::ranges::fill(sums_, Vec3{});
    for (std::size_t unit = 0; unit < units_.size(); ++unit) fit_unit(unit, positions);
    for (BarIndex bar : rods_) fit_rod(bar, positions, key);
    for (Joint joint = 0; joint < positions.size(); ++joint) {
      if (counts_[joint] == 0.0 || framework_.is_pinned(joint)) continue;
      const double height = positions[joint].z;
      positions[joint] = (1.0 / counts_[joint]) * sums_[joint];
      if (framework_.is_planar()) positions[joint].z = height;
    }
  }

  void fit_unit(std::size_t unit, std::span<const Vec3> positions) {
    const auto joints = units_.at(unit);
    const auto points = points_at(unit);
    TurnAboutPoint turn(middle_of(joints, positions, [](Joint joint, auto) { return joint; }));
    for (std::size_t k = 0; k < joints.size(); ++k)
      turn.add(points[k], positions[joints[k]], weights_[joints[k]]);
    turn.fit(mirrors_[unit] != 0);
    for (std::size_t k = 0; k < joints.size(); ++k) sums_[joints[k]] += turn(points[k]);
  }

  void fit_rod(BarIndex bar, std::span<const Vec3> positions, const RandomKey& key) {
    const auto [a, b] = std::minmax(framework_.bars()[bar].a, framework_.bars()[bar].b);
    Vec3 at_a = positions[a], at_b = positions[b];
    const double share = weights_[b] / (weights_[a] + weights_[b]);
    project_bar(at_a, at_b, framework_.rest_lengths()[bar], share, 1.0 - share,
                [&] { return escape_direction(key, bar, framework_.is_planar()); });
    sums_[a] += at_a;
    sums_[b] += at_b;
  }

  const Framework& framework_;
  ResolveOptions options_;
  bool keeps_centre_;
  std::unique_ptr<LimitSweep> limits_;       ///< null: bars only
  std::unique_ptr<NeighbourList> contacts_;  ///< null: no sterics
  UnitSet units_;                            ///< templates of three or more joints
  std::vector<Vec3> points_;           ///< as UnitSet::things, from the unit's middle (Angstrom)
  std::vector<std::uint8_t> mirrors_;  ///< of units: may be the mirror image
  std::vector<BarIndex> rods_;         ///< templates of two joints
  std::vector<double> counts_;         ///< (N) templates that hold the joint
  std::vector<double> weights_;        ///< (N) in fits
  Acceleration acceleration_;
  std::vector<Vec3> sums_;  ///< (N) of where templates have the joint
};

}  // namespace

std::unique_ptr<Method> make_templates(const Framework& framework, const Technique& technique,
                                       const ResolveOptions& options) {
  return std::make_unique<Templates>(framework, technique, options);
}

}  // namespace pliant
