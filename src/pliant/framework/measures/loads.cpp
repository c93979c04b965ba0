// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/loads.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/framework/measures/neighbour_list.hpp"

namespace pliant {
namespace {

enum class RowKind : std::uint8_t { bar, limit, pair };

/// A force along n on `a`, and the opposite on `b`. Of a limit or a pair it is from 0.
struct Row {
  Joint a, b;
  Vec3 n;
  RowKind kind;
  std::uint32_t index;  ///< of the bar or limit
  double step = 0.0;    ///< of a gradient: one over a bound of all that it acts on
  double load = 0.0, before = 0.0, ahead = 0.0;
};

class LoadSolver {
 public:
  LoadSolver(const Framework& framework, std::span<const Vec3> x, const LoadOptions& options)
      : framework_(framework), x_(x), options_(options), force_(framework.joint_count()) {
    add_bars();
    add_limits();
    if (framework.sterics() != nullptr) add_pairs();
    set_steps();
  }

  Loads solve(std::span<const Load> pull) {
    double largest = 0.0;
    for (const Load& one : pull) largest = std::max(largest, norm(one.force));
    double momentum = 1.0;
    int passes = 0;
    while (passes < options_.most_passes) {
      ++passes;
      sum_forces(pull, &Row::ahead);
      if (!(pass(momentum) > options_.accuracy * largest) && passes > 1) break;
    }
    sum_forces(pull, &Row::load);
    return told(passes);
  }

 private:
  void add(Joint a, Joint b, RowKind kind, std::size_t index, double sign) {
    const Vec3 apart = x_[a] - x_[b];
    const double length = norm(apart);
    if (!(length > 0.0)) return;
    if (framework_.is_pinned(a) && framework_.is_pinned(b)) return;
    rows_.push_back({a, b, (sign / length) * apart, kind, static_cast<std::uint32_t>(index)});
  }

  void add_bars() {
    const auto bars = framework_.bars();
    for (std::size_t k = 0; k < bars.size(); ++k) add(bars[k].a, bars[k].b, RowKind::bar, k, 1.0);
  }

  void add_limits() {
    const auto limits = framework_.limits();
    for (std::size_t k = 0; k < limits.size(); ++k) {
      const Limit& limit = limits[k];
      const double length = distance(x_[limit.a], x_[limit.b]);
      if (length > limit.most - options_.slack) add(limit.a, limit.b, RowKind::limit, k, -1.0);
      if (length < limit.least + options_.slack) add(limit.a, limit.b, RowKind::limit, k, 1.0);
    }
  }

  void add_pairs() {
    NeighbourList list(framework_);
    if (!list.update(x_)) return;
    for (const NeighbourPair& pair : list.near())
      if (distance(x_[pair.a], x_[pair.b]) < pair.least + options_.slack)
        add(pair.a, pair.b, RowKind::pair, 0, 1.0);
  }

  double mobility(Joint joint) const { return framework_.is_pinned(joint) ? 0.0 : 1.0; }

  void set_steps() {
    std::vector<double> at(framework_.joint_count(), 0.0);
    for (const Row& row : rows_) {
      at[row.a] += mobility(row.a);
      at[row.b] += mobility(row.b);
    }
    for (Row& row : rows_) row.step = 1.0 / (at[row.a] + at[row.b]);
  }

  void sum_forces(std::span<const Load> pull, double Row::*load) {
    std::fill(force_.begin(), force_.end(), Vec3{});
    for (const Load& one : pull) force_[one.joint] += one.force;
    for (const Row& row : rows_) {
      const Vec3 along = (row.*load) * row.n;
      force_[row.a] += along;
      force_[row.b] -= along;
    }
  }

  /// One step of the gradient from the loads ahead. Returns by how much the largest has changed.
  /// Where the step goes against the last one, momentum begins anew.
  double pass(double& momentum) {
    double change = 0.0, against = 0.0;
    for (Row& row : rows_) {
      const double gradient =
          dot(row.n, mobility(row.a) * force_[row.a] - mobility(row.b) * force_[row.b]);
      row.before = row.load;
      row.load = row.ahead - row.step * gradient;
      if (row.kind != RowKind::bar) row.load = std::max(row.load, 0.0);
      change = std::max(change, std::abs(row.load - row.before));
      against += gradient * (row.load - row.before);
    }
    if (against > 0.0) momentum = 1.0;
    const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
    const double share = (momentum - 1.0) / next;
    for (Row& row : rows_) row.ahead = row.load + share * (row.load - row.before);
    momentum = next;
    return change;
  }

  Loads told(int passes) const {
    Loads found;
    found.passes = passes;
    found.bars.assign(framework_.bar_count(), 0.0);
    found.limits.assign(framework_.limits().size(), 0.0);
    found.pins.assign(framework_.joint_count(), 0.0);
    found.motion = force_;
    for (const Row& row : rows_) {
      if (row.kind == RowKind::bar) found.bars[row.index] = -row.load;
      if (row.kind == RowKind::limit) found.limits[row.index] += row.load;
      if (row.kind == RowKind::pair && row.load > 0.0)
        found.pressed.push_back({row.a, row.b, row.load});
    }
    for (Joint joint = 0; joint < force_.size(); ++joint) {
      if (!framework_.is_pinned(joint)) continue;
      found.pins[joint] = norm(force_[joint]);
      found.motion[joint] = {};
    }
    return found;
  }

  const Framework& framework_;
  std::span<const Vec3> x_;
  LoadOptions options_;
  std::vector<Row> rows_;
  std::vector<Vec3> force_;  ///< on each joint
};

}  // namespace

Loads find_loads(const Framework& framework, std::span<const Vec3> positions,
                 std::span<const Load> pull, const LoadOptions& options) {
  return LoadSolver(framework, positions, options).solve(pull);
}

}  // namespace pliant
