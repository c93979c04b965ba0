// SPDX-License-Identifier: MIT
#include "pliant/rigidity/bar_rank.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "pliant/base/math/symmetric_eigen.hpp"
#include "pliant/base/random.hpp"
#include "pliant/rigidity/row_reduction.hpp"

namespace pliant {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};
constexpr double nearly = 1e-4;
/// A bar that random factors of self-stresses miss once, they hardly miss as often as this.
constexpr int draws_of_stress = 3;

/// Which columns the coordinates of a joint have, and in which order the rows of bars come.
struct Layout {
  std::uint32_t dimension;
  std::size_t columns = 0;
  std::vector<std::uint32_t> first;  ///< (N) the first column of each joint; none: pinned
  std::vector<BarIndex> order;       ///< (B)
};

/// Minimum degree: a joint with few neighbours comes early (Amestoy, Davis, Duff, SIAM J. Matrix
/// Anal. 17 (1996) 886).
std::vector<Joint> joints_by_degree(const Framework& framework) {
  const auto size = Eigen::Index(framework.joint_count());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index k = 0; k < size; ++k) entries.emplace_back(k, k, 1.0);
  for (const Bar bar : framework.bars()) {
    if (framework.is_pinned(bar.a) || framework.is_pinned(bar.b)) continue;
    entries.emplace_back(bar.a, bar.b, 1.0);
    entries.emplace_back(bar.b, bar.a, 1.0);
  }
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> sequence;
  Eigen::AMDOrdering<int>()(matrix, sequence);
  std::vector<Joint> joints;
  for (Eigen::Index k = 0; k < size; ++k) joints.push_back(Joint(sequence.indices()[k]));
  return joints;
}

Layout layout_of(const Framework& framework, std::uint32_t dimension) {
  Layout layout{dimension, 0, std::vector<std::uint32_t>(framework.joint_count(), none), {}};
  for (const Joint joint : joints_by_degree(framework)) {
    if (framework.is_pinned(joint)) continue;
    layout.first[joint] = std::uint32_t(layout.columns);
    layout.columns += dimension;
  }
  layout.order.resize(framework.bar_count());
  std::iota(layout.order.begin(), layout.order.end(), BarIndex{0});
  const auto place = [&](BarIndex k) {
    const std::uint32_t a = layout.first[framework.bars()[k].a];
    const std::uint32_t b = layout.first[framework.bars()[k].b];
    if (a == none || b == none) return std::pair(std::min(a, b), std::min(a, b));
    return std::pair(std::max(a, b), std::min(a, b));
  };
  std::stable_sort(layout.order.begin(), layout.order.end(),
                   [&](BarIndex a, BarIndex b) { return place(a) < place(b); });
  return layout;
}

/// The row of a bar: `along` at the coordinates of b, minus it at those of a.
template <class Entry, class Number>
std::vector<Entry> row_of(const Layout& layout, Bar bar, const std::array<Number, 3>& along) {
  std::vector<Entry> row;
  for (const Joint joint : {bar.a, bar.b})
    for (std::uint32_t c = 0; c < layout.dimension && layout.first[joint] != none; ++c)
      row.push_back({layout.first[joint] + c, joint == bar.a ? Number{} - along[c] : along[c]});
  std::sort(row.begin(), row.end(),
            [](const Entry& x, const Entry& y) { return x.column < y.column; });
  return row;
}

/// A unit vector along each bar (B), or 0 where its ends coincide.
std::vector<std::array<double, 3>> bar_directions(const Framework& framework,
                                                  std::span<const Vec3> positions, bool in_plane) {
  std::vector<std::array<double, 3>> directions;
  for (const Bar bar : framework.bars()) {
    Vec3 along = positions[bar.b] - positions[bar.a];
    if (in_plane) along.z = 0.0;
    const double length = norm(along);
    if (length > 0.0) along *= 1.0 / length;
    directions.push_back({along.x, along.y, along.z});
  }
  return directions;
}

using Directions = std::vector<std::array<double, 3>>;

/// Eigenvalues of [0 A; A^T 0] are plus and minus the singular values of A, and the rest 0, all to
/// rounding; of A A^T they would be squares, of which half the digits are lost.
DenseMatrix doubled(const Framework& framework, const Layout& layout, const Directions& along) {
  struct Entry {
    std::uint32_t column;
    double value;
  };
  const std::size_t bars = framework.bar_count();
  DenseMatrix matrix(bars + layout.columns, bars + layout.columns);
  for (std::size_t k = 0; k < bars; ++k)
    for (const Entry& entry : row_of<Entry>(layout, framework.bars()[k], along[k]))
      matrix(k, bars + entry.column) = matrix(bars + entry.column, k) = entry.value;
  return matrix;
}

BarRankThere rank_by_singular_values(const Framework& framework, const Layout& layout,
                                     const Directions& along) {
  const EigenPairs pairs = symmetric_eigen(doubled(framework, layout, along));
  BarRankThere found;
  found.has_singular_values = true;
  found.stresses.assign(framework.bar_count(), 0.0);
  for (std::size_t k = 0; k < pairs.values.size(); ++k) {
    const double value = pairs.values[k];
    if (value > rank_tolerance) {
      if (found.rank++ == 0) found.least = value;
      if (value < nearly) found.nearly_dependent.push_back(value);
    } else if (value >= -rank_tolerance) {
      found.dropped = std::max(found.dropped, std::abs(value));
      for (std::size_t bar = 0; bar < found.stresses.size(); ++bar)
        found.stresses[bar] += pairs.vectors(k, bar) * pairs.vectors(k, bar);
    }
  }
  for (const double stress : found.stresses)
    found.redundant.push_back(std::sqrt(stress) > stress_tolerance);
  return found;
}

double length_of(const auto& row) {
  double sum = 0.0;
  for (const auto& entry : row) sum += entry.value * entry.value;
  return std::sqrt(sum);
}

/// Adds all rows, and takes each bar for redundant that `is_stressed(factors, row)`.
template <class Reduction, class AlongBar, class Vanishes>
void reduce(Reduction& reduction, const Framework& framework, const Layout& layout,
            const AlongBar& along, const Vanishes& vanishes, BarRank& found) {
  found.redundant.assign(framework.bar_count(), false);
  found.stresses.assign(framework.bar_count(), 0.0);
  for (const BarIndex bar : layout.order) {
    auto row = row_of<typename Reduction::Entry>(layout, framework.bars()[bar], along(bar));
    const bool is_independent = reduction.add(std::move(row), vanishes);
    found.rank += is_independent;
    found.stresses[bar] = is_independent ? 0.0 : 1.0;
  }
}

BarRankThere rank_by_rotations(const Framework& framework, const Layout& layout,
                               const Directions& along) {
  BarRankThere found;
  const auto vanishes = [&](const auto& row) {
    const double length = length_of(row);
    if (length <= rank_tolerance) {
      found.dropped = std::max(found.dropped, length);
      return true;
    }
    if (length < nearly) found.nearly_dependent.push_back(length);
    found.least = found.least > 0.0 ? std::min(found.least, length) : length;
    return false;
  };
  RowReduction<RowRotation> reduction(layout.columns);
  reduce(
      reduction, framework, layout, [&](BarIndex bar) { return along[bar]; }, vanishes, found);
  std::sort(found.nearly_dependent.begin(), found.nearly_dependent.end());
  if (found.rank == framework.bar_count()) return found;
  RandomSequence random({0, Domain::generate, 0, 0, 0});
  for (int draw = 0; draw < draws_of_stress; ++draw) {
    const std::vector<double> factors =
        reduction.vanishing_factors([&] { return 2.0 * random.uniform() - 1.0; });
    double largest = 0.0;
    for (const double factor : factors) largest = std::max(largest, std::abs(factor));
    for (std::size_t k = 0; k < factors.size(); ++k)
      if (std::abs(factors[k]) > stress_tolerance * largest)
        found.redundant[layout.order[k]] = true;
  }
  return found;
}

}  // namespace

BarRankThere bar_rank(const Framework& framework, std::span<const Vec3> positions,
                      std::uint32_t dimension) {
  const Layout layout = layout_of(framework, dimension);
  const Directions along = bar_directions(framework, positions, dimension == 2);
  if (framework.bar_count() + layout.columns <= most_for_singular_values)
    return rank_by_singular_values(framework, layout, along);
  return rank_by_rotations(framework, layout, along);
}

BarRank generic_bar_rank(const Framework& framework, std::uint32_t dimension) {
  const Layout layout = layout_of(framework, dimension);
  const auto coordinate = [&](Joint joint, std::uint64_t axis) {
    RandomSequence random({1, Domain::generate, 0, axis, joint});
    return ModularNumber(random.below(ModularNumber::prime));
  };
  const auto along = [&](BarIndex k) {
    const Bar bar = framework.bars()[k];
    std::array<ModularNumber, 3> direction;
    for (std::uint32_t c = 0; c < 3; ++c)
      direction[c] = coordinate(bar.b, c) - coordinate(bar.a, c);
    return direction;
  };
  BarRank found;
  RowReduction<RowElimination> reduction(layout.columns);
  reduce(
      reduction, framework, layout, along, [](const auto&) { return false; }, found);
  if (found.rank == framework.bar_count()) return found;
  RandomSequence random({2, Domain::generate, 0, 0, 0});
  const auto factors = reduction.vanishing_factors(
      [&] { return ModularNumber(random.below(ModularNumber::prime)); });
  for (std::size_t k = 0; k < factors.size(); ++k)
    found.redundant[layout.order[k]] = !(factors[k] == ModularNumber());
  return found;
}

}  // namespace pliant
