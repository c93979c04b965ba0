// SPDX-License-Identifier: MIT
#include "pliant/fit/map/density_term.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/base/math/cell_list.hpp"
#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

constexpr double weight_per_node = 2.0;  // of 1 - c^2
constexpr std::size_t coarse_stages = 2;
constexpr double reach = 3.5;   // in roots of 2 sigma: e^-6 is left
constexpr double margin = 3.0;  // Angstrom: as nodes move meanwhile

double cubed(double x) { return x * x * x; }

}  // namespace

void DensityTerm::begin(std::size_t stage, std::span<const Vec3> nodes) {
  level_ = stage < coarse_stages ? &target_.coarse() : &target_.fine();
  weight_ = weight_per_node * fit_weights[stage] * static_cast<double>(nodes.size());
  near_.clear();
  const std::vector<Vec3> places = level_->sites.places(nodes);
  const double cutoff = reach * std::numbers::sqrt2 * level_->sigma + margin;
  CellList(places, cutoff).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    near_.emplace_back(i, j);
  });
  held_.assign(places.size(), 1.0);
  weigh(places);
}

/// Finds the density of a unit of mass, as three quarters of the points of mass have it at most:
/// the scale that is best for all would be too small where density is missing, and what is there
/// would draw everything. Points with less than half of that are held by the map in part.
void DensityTerm::weigh(std::span<const Vec3> places) {
  const Overlap map = with_map(places), own = with_itself(places);
  std::vector<double> ratios;
  for (std::size_t k = 0; k < places.size(); ++k) ratios.push_back(map.parts[k] / own.parts[k]);
  std::vector<double> sorted = ratios;
  const auto chosen = sorted.begin() + static_cast<std::ptrdiff_t>(3 * sorted.size() / 4);
  std::nth_element(sorted.begin(), chosen, sorted.end());
  scale_ = std::max(*chosen, map.value() / own.value());
  for (std::size_t k = 0; k < places.size(); ++k)
    held_[k] = std::clamp(2.0 * ratios[k] / scale_, 0.0, 1.0);
}

/// The integral of map x Gaussians.
DensityTerm::Overlap DensityTerm::with_map(std::span<const Vec3> places) const {
  const double integral = cubed(std::sqrt(2.0 * std::numbers::pi) * level_->sigma);
  Overlap out;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double factor = integral * level_->sites.weight(k);
    const DensityAt found = level_->convolved.at(places[k]);
    out.parts.push_back(factor * found.value);
    out.slopes.push_back(factor * found.gradient);
  }
  return out;
}

/// The integral of the square of all Gaussians.
DensityTerm::Overlap DensityTerm::with_itself(std::span<const Vec3> places) const {
  const double variance = level_->sigma * level_->sigma;
  const double integral = cubed(std::sqrt(std::numbers::pi) * level_->sigma);
  Overlap out{{}, std::vector<Vec3>(places.size())};
  for (std::size_t k = 0; k < places.size(); ++k)
    out.parts.push_back(integral * level_->sites.weight(k) * level_->sites.weight(k));
  for (const auto& [i, j] : near_) {
    const Vec3 between = places[i] - places[j];
    const double squared = norm_squared(between);
    if (squared > 2.0 * reach * reach * variance) continue;
    // What the map does not hold would else be driven apart, as nothing is expected there.
    const double shared = std::max(held_[i], held_[j]) * integral * level_->sites.weight(i) *
                          level_->sites.weight(j) * exact_bits_exp(-0.25 * squared / variance);
    out.parts[i] += shared;
    out.parts[j] += shared;
    const Vec3 slope = (-shared / variance) * between;
    out.slopes[i] += slope;
    out.slopes[j] -= slope;
  }
  return out;
}

double DensityTerm::add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const {
  const std::vector<Vec3> places = level_->sites.places(nodes);
  const Overlap map = with_map(places), own = with_itself(places);
  const double factor = weight_ * scale_ / (level_->norm * level_->norm);
  std::vector<Vec3> slopes(places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    slopes[k] = factor * (scale_ * own.slopes[k] - 2.0 * map.slopes[k]);
  level_->sites.add_gradient(nodes, slopes, gradient);
  return weight_ + factor * (scale_ * own.value() - 2.0 * map.value());
}

double DensityTerm::correlation(std::span<const Vec3> nodes) {
  held_.assign(level_->sites.size(), 1.0);
  const std::vector<Vec3> places = level_->sites.places(nodes);
  return with_map(places).value() / (level_->norm * std::sqrt(with_itself(places).value()));
}

}  // namespace pliant
