// SPDX-License-Identifier: MIT
// A density map as a term of a fit.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "pliant/fit/fit_term.hpp"
#include "pliant/fit/map/density_target.hpp"
#include "pliant/fit/residue_sites.hpp"

namespace pliant {

/// w N |map - s mass|^2 / |map|^2: what is left of the map once the molecule's own density is taken
/// from it. s scales masses to densities (see weigh()), N is the number of nodes, w grows from
/// stage to stage; the first stages look at the coarse map. As the molecule's own density counts,
/// nodes are not drawn into each other where the map is densest.
class DensityTerm : public FitTerm {
 public:
  /// The target must outlive it.
  explicit DensityTerm(const DensityTarget& target) : target_(target) {}
  void begin(std::size_t stage, std::span<const Vec3> nodes) override;
  double add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const override;

  /// The correlation at the level of the stage.
  double correlation(std::span<const Vec3> nodes);

 private:
  struct Overlap {
    std::vector<double> parts;  ///< of each point of mass
    std::vector<Vec3> slopes;   ///< of their sum, by place
    double value() const { return std::accumulate(parts.begin(), parts.end(), 0.0); }
  };
  void weigh(std::span<const Vec3> places);
  Overlap with_map(std::span<const Vec3> places) const;
  Overlap with_itself(std::span<const Vec3> places) const;

  const DensityTarget& target_;
  const DensityLevel* level_ = nullptr;
  double weight_ = 0.0, scale_ = 0.0;
  std::vector<double> held_;  ///< from 0 to 1: how far the map holds each point of mass
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near_;
};

}  // namespace pliant
