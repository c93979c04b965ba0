// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/bar_equations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/resolve/equations/bar_loops.hpp"
#include "pliant/resolve/method/project_bar.hpp"

namespace pliant {
namespace {

/// Beyond so many pairs of bars that share a joint, a bar, memory and time would no longer be
/// linear in the bars: hubs of thousands of bars. Molecules have up to about 15.
constexpr std::size_t most_couplings_a_bar = 32;
constexpr auto nowhere = std::numeric_limits<std::uint32_t>::max();

/// The joints of the bars in the sequence in which the bars name them first, the lower joint of a
/// bar before the other: which end the input names first must not matter.
std::vector<Joint> joints_of(const Framework& framework, std::span<const BarIndex> bars,
                             std::vector<std::uint32_t>& place) {
  std::vector<Joint> joints;
  for (const BarIndex bar : bars) {
    const auto [a, b] = framework.bars()[bar];
    for (const Joint joint : {std::min(a, b), std::max(a, b)}) {
      if (place[joint] != nowhere) continue;
      place[joint] = static_cast<std::uint32_t>(joints.size());
      joints.push_back(joint);
    }
  }
  return joints;
}

using BarsAtJoints = Grouped<std::uint32_t>;

BarsAtJoints bars_at_joints(std::span<const EquationEnds> ends, std::size_t joint_count) {
  return {joint_count, [&](const auto& put) {
            for (std::uint32_t k = 0; k < ends.size(); ++k) {
              put(ends[k].a, k);
              put(ends[k].b, k);
            }
          }};
}

std::size_t count_couplings(const BarsAtJoints& bars, std::size_t joint_count) {
  std::size_t count = 0;
  for (std::size_t j = 0; j < joint_count; ++j)
    count += bars.at(j).size() * (bars.at(j).size() - 1) / 2;
  return count;
}

/// The pairs of bars that share a joint, by their places in the elimination.
std::vector<SparseLdl::Entry> couplings(const BarsAtJoints& bars, std::size_t joint_count,
                                        std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) place[order[k]] = k;
  std::vector<SparseLdl::Entry> entries;
  for (std::size_t j = 0; j < joint_count; ++j)
    for (const std::uint32_t one : bars.at(j))
      for (const std::uint32_t other : bars.at(j))
        if (place[one] < place[other]) entries.push_back({place[one], place[other]});
  return entries;
}

}  // namespace

BarEquations::BarEquations(const Framework& framework, std::vector<double> weights,
                           const Tolerance& tolerance)
    : framework_(framework),
      all_weights_(std::move(weights)),
      tolerance_(tolerance),
      place_(framework.joint_count(), nowhere) {}

std::optional<BarEquations::Part> BarEquations::append(std::span<const BarIndex> bars) {
  std::vector<Joint> joints = joints_of(framework_, bars, place_);
  std::vector<EquationEnds> ends;
  for (const BarIndex bar : bars)
    ends.push_back({place_[framework_.bars()[bar].a], place_[framework_.bars()[bar].b]});
  for (const Joint joint : joints) place_[joint] = nowhere;
  const BarsAtJoints at_joints = bars_at_joints(ends, joints.size());
  if (count_couplings(at_joints, joints.size()) > most_couplings_a_bar * bars.size()) return {};
  const std::vector<std::uint32_t> order = elimination_order(ends, joints.size());
  Part part;
  part.bars = ldl_.append(static_cast<std::uint32_t>(bars.size()),
                          couplings(at_joints, joints.size(), order));
  if (part.bars.size() == 0) return {};
  const auto first = static_cast<std::uint32_t>(joints_.size());
  part.joints = {first, first + static_cast<std::uint32_t>(joints.size())};
  append_bars(bars, order, part);
  return part;
}

/// Bars in the sequence of elimination, joints in the sequence in which these name them.
void BarEquations::append_bars(std::span<const BarIndex> bars, std::span<const std::uint32_t> order,
                               Part part) {
  for (const std::uint32_t k : order) bars_.push_back(bars[k]);
  const std::span<const BarIndex> sorted(bars_.data() + part.bars.begin, part.bars.size());
  for (const Joint joint : joints_of(framework_, sorted, place_)) {
    joints_.push_back(joint);
    weights_.push_back(all_weights_[joint]);
  }
  for (const BarIndex bar : sorted) {
    const Bar& joints = framework_.bars()[bar];
    const double rest = framework_.rest_lengths()[bar];
    ends_.push_back({part.joints.begin + place_[joints.a], part.joints.begin + place_[joints.b]});
    rests_.push_back(rest);
    allowed_.push_back(tolerance_.of(rest));
    per_allowed_.push_back(1.0 / allowed_.back());
  }
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j) place_[joints_[j]] = nowhere;
  x_.resize(joints_.size());
  d_.resize(bars_.size());
  excess_.resize(bars_.size());
  diagonal_weights_.resize(bars_.size());
  couplings_.resize(ldl_.entry_count());
  weigh_entries(part);
}

void BarEquations::weigh_entries(Part part) {
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) {
    const EquationEnds own = ends_[k];
    diagonal_weights_[k] = weights_[own.a] + weights_[own.b];
    const Range entries = ldl_.column(k);
    for (std::uint32_t p = entries.begin; p < entries.end; ++p) {
      const EquationEnds other = ends_[ldl_.row(p)];
      double& coupling = couplings_[p] = 0.0;  // stays 0 where only factoring fills
      if (own.a == other.a || own.b == other.b)
        coupling = weights_[own.a == other.a ? own.a : own.b];
      else if (own.a == other.b || own.b == other.a)
        coupling = -weights_[own.a == other.b ? own.a : own.b];
    }
  }
}

BarPattern BarEquations::pattern(Part part) const {
  return {part.bars,       part.joints,         ldl_.pattern(),
          joints_.data(),  ends_.data(),        rests_.data(),
          allowed_.data(), per_allowed_.data(), diagonal_weights_.data(),
          weights_.data(), couplings_.data()};
}

void BarEquations::gather(Part part, std::span<const Vec3> from) {
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j) x_[j] = from[joints_[j]];
}

void BarEquations::scatter(Part part, std::span<Vec3> to) const {
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j)
    if (weights_[j] > 0.0) to[joints_[j]] = x_[j];
}

void BarEquations::hold(Part part, Joint held) {
  bool changed = false;
  for (std::uint32_t j = part.joints.begin; j < part.joints.end; ++j) {
    const double weight = joints_[j] == held ? 0.0 : all_weights_[joints_[j]];
    changed |= weight != weights_[j];
    weights_[j] = weight;
  }
  if (changed) weigh_entries(part);
}

BarEquations::Errors BarEquations::measure(Part part) {
  Errors errors;
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) {
    const Vec3 delta = x_[ends_[k].b] - x_[ends_[k].a];
    const double squared = norm_squared(delta);
    const double length = std::sqrt(squared);
    const double error = length - rests_[k];
    d_[k] = delta;
    excess_[k] = length * error;
    errors.whole &= std::abs(error) <= allowed_[k];
    errors.finite &= length < infinity;
    errors.coincident |= squared < least_squared_length;
    errors.worst = std::max(errors.worst, std::abs(error) * per_allowed_[k]);
  }
  return errors;
}

bool BarEquations::is_coincident(std::uint32_t k) const {
  return !(norm_squared(x_[ends_[k].b] - x_[ends_[k].a]) >= least_squared_length);
}

double BarEquations::relative_error(Part part) const {
  double worst = 0.0;
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k)
    worst = std::max(worst, std::abs(norm(d_[k]) - rests_[k]) / rests_[k]);
  return worst;
}

double BarEquations::sum_of_squares(Part part) const {
  double sum = 0.0;
  for (std::uint32_t k = part.bars.begin; k < part.bars.end; ++k) {
    const double error = norm(d_[k]) - rests_[k];
    if (diagonal_weights_[k] > 0.0) sum += error * error / diagonal_weights_[k];
  }
  return sum;
}

std::int64_t BarEquations::factor(Part part, std::span<const Vec3> directions, double damping) {
  const std::uint32_t first = part.bars.begin;
  fill_gram(pattern(part), directions.data() + first, damping, ldl_.diagonal().data() + first,
            ldl_.lower().data() + ldl_.column(first).begin);
  return ldl_.factor(part.bars);
}

void BarEquations::stretch(Part part, std::span<const Vec3> directions, std::span<const Vec3> v,
                           std::span<double> out) const {
  stretch_bars(pattern(part), directions.data() + part.bars.begin, v.data() + part.joints.begin,
               out.data() + part.bars.begin);
}

void BarEquations::pull(Part part, std::span<const Vec3> directions, std::span<const double> lambda,
                        std::span<Vec3> v) const {
  pull_joints(pattern(part), directions.data() + part.bars.begin, lambda.data() + part.bars.begin,
              v.data() + part.joints.begin);
}

}  // namespace pliant
