// SPDX-License-Identifier: MIT
#include "pliant/fit/map/simulated.hpp"

#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr double cut_off = 5.0;  ///< in sigma

void check_atoms(std::span<const Vec3> positions) {
  if (positions.empty()) throw InputError("positions: expected one atom or more, found none");
  for (std::size_t k = 0; k < positions.size(); ++k)
    if (!is_finite(positions[k]))
      throw InputError("positions: row " + std::to_string(k) + " is not finite");
}

/// Adds a Gaussian to maps of one grid.
class GaussianAdder {
 public:
  GaussianAdder(const MapGrid& grid, double sigma)
      : grid_(grid),
        places_(grid),
        radius_(cut_off * sigma),
        per_square_(0.5 / (sigma * sigma)),
        curve_(per_square_ * norm_squared(grid.steps[2])) {}

  void add(Vec3 center, double weight, std::vector<double>& values) const {
    const GridBox box = box_around(grid_, places_, center, radius_);
    if (box.low[2] >= box.high[2]) return;
    const Grid points = grid_.points();
    for (std::size_t i = box.low[0]; i < box.high[0]; ++i)
      for (std::size_t j = box.low[1]; j < box.high[1]; ++j) {
        const Vec3 first = grid_.place(static_cast<double>(i), static_cast<double>(j),
                                       static_cast<double>(box.low[2]));
        add_row(first - center, weight,
                std::span(values).subspan(points.at(i, j, box.low[2]), box.high[2] - box.low[2]));
      }
  }

 private:
  /// The exponent along a row is a parabola, so each value is the one before times a ratio that
  /// itself changes by a constant factor: from the point nearest to the atom both ways, since so
  /// nothing grows.
  void add_row(Vec3 from_center, double weight, std::span<double> row) const {
    const Vec3 step = grid_.steps[2];
    const double nearest = std::clamp(std::round(-dot(from_center, step) / norm_squared(step)), 0.0,
                                      static_cast<double>(row.size() - 1));
    const Vec3 from = from_center + nearest * step;
    if (norm_squared(from) > radius_ * radius_) return;
    const double value = weight * exact_bits_exp(-per_square_ * norm_squared(from));
    const double slope = 2.0 * per_square_ * dot(from, step);
    const auto middle = static_cast<std::size_t>(nearest);
    add_along(value, slope, row.subspan(middle).begin(), row.end());
    const auto before =
        std::make_reverse_iterator(row.begin() + static_cast<std::ptrdiff_t>(middle));
    const double back = exact_bits_exp(slope - curve_);
    add_along(value * back, -slope + 2.0 * curve_, before, row.rend());
  }

  /// Adds from a value on which changes by exp(-slope - curve) to the next.
  template <class Place>
  void add_along(double value, double slope, Place place, Place end) const {
    double ratio = exact_bits_exp(-slope - curve_);
    for (; place != end; ++place) {
      *place += value;
      value *= ratio;
      ratio *= ratio_change_;
    }
  }

  MapGrid grid_;
  PlacesOnGrid places_;
  double radius_, per_square_, curve_;
  double ratio_change_ = exact_bits_exp(-2.0 * curve_);
};

}  // namespace

MapGrid grid_around(std::span<const Vec3> positions, double resolution, double spacing) {
  check_resolution(resolution);
  if (!(spacing >= 0.05 && spacing <= 100.0))
    throw OptionError("spacing = " + number_text(spacing) +
                      ": must be from 0.05 to 100 (Angstrom)");
  check_atoms(positions);
  const Extent around = extent_of(positions);
  const double margin = cut_off * sigma_per_resolution * resolution;
  const auto step_of = [&](double place) { return std::floor(place / spacing); };
  const std::array<double, 3> low{step_of(around.low.x - margin), step_of(around.low.y - margin),
                                  step_of(around.low.z - margin)};
  const std::array<double, 3> high{step_of(around.high.x + margin), step_of(around.high.y + margin),
                                   step_of(around.high.z + margin)};
  MapGrid grid;
  grid.origin = {low[0] * spacing, low[1] * spacing, low[2] * spacing};
  grid.steps = {Vec3{spacing, 0, 0}, Vec3{0, spacing, 0}, Vec3{0, 0, spacing}};
  for (std::size_t k = 0; k < 3; ++k)
    grid.count[k] = static_cast<std::size_t>(std::min(high[k] - low[k] + 2.0, 1e9));
  check(grid);
  return grid;
}

DensityMap simulated(const MapGrid& grid, std::span<const Vec3> positions,
                     std::span<const double> weights, double resolution) {
  check_resolution(resolution);
  check(grid);
  check_atoms(positions);
  if (weights.size() != positions.size())
    throw InputError("weights: expected " + std::to_string(positions.size()) +
                     ", one for each position, found " + std::to_string(weights.size()));
  if (!std::all_of(weights.begin(), weights.end(), [](double one) { return std::abs(one) < 1e9; }))
    throw InputError("weights: expected finite numbers");
  const GaussianAdder adder(grid, sigma_per_resolution * resolution);
  std::vector<double> sums(grid.size(), 0.0);
  for (std::size_t k = 0; k < positions.size(); ++k) adder.add(positions[k], weights[k], sums);
  return {grid, std::vector<float>(sums.begin(), sums.end())};
}

}  // namespace pliant
