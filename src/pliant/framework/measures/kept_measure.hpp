// SPDX-License-Identifier: MIT
// Measures one walker again and again, looking only at what has moved.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/measures/moved_pairs.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// Returns what measure() returns, bit for bit, whatever was measured before. Bars, limits and near
/// pairs are measured anew only if the bits of a position near them have changed since the last
/// call. Not thread-safe.
class KeptMeasure {
 public:
  /// The framework must outlive it.
  KeptMeasure(const Framework& framework, const Tolerance& tolerance);

  /// Measures `positions` (N) as measure() does.
  ResidualSummary measure(std::span<const Vec3> positions, LimitsOff off = {});
  /// Measures only bars and limits; the result has no overlaps.
  ResidualSummary measure_bars_and_limits(std::span<const Vec3> positions, LimitsOff off = {});

  /// Number of bars, limits and near pairs measured so far.
  std::int64_t visits() const { return visits_; }

 private:
  /// The largest value of one group of pairs; for bars also the largest length error (Angstrom).
  struct Part {
    double most = 0.0, most_length = 0.0;
    std::uint32_t worst = 0;
    bool within = true, finite = true;

    void take(double value, std::size_t index) {
      if (!(value > most)) return;
      most = value;
      worst = static_cast<std::uint32_t>(index);
    }
  };

  void look(std::span<const Vec3> positions);
  void renew_bars(std::span<const Vec3> positions);
  void renew_limits(std::span<const Vec3> positions, LimitsOff off);
  bool renew_overlaps(std::span<const Vec3> positions);
  Part part_of_bars(std::span<const Vec3> positions, std::size_t group);
  Part part_of_limits(std::span<const Vec3> positions, std::size_t group) const;
  Part part_of_overlaps(std::span<const Vec3> positions, std::size_t group) const;
  bool take_bars(ResidualSummary& summary) const;
  bool take_limits(ResidualSummary& summary) const;
  void take_overlaps(ResidualSummary& summary) const;
  double sum_of_squares();

  const Framework& framework_;
  Tolerance tolerance_;
  std::unique_ptr<NeighbourList> neighbours_;  ///< null: no sterics
  std::int64_t lists_made_ = -1;               ///< of neighbours_, when overlaps_ was assigned
  MovedPositions moved_;
  bool has_moved_ = true;  ///< since neighbours_ looked
  MovedPairs bars_, limits_, overlaps_;
  std::vector<Part> bar_parts_, limit_parts_, overlap_parts_;
  std::vector<double> squares_;  ///< (bars) squared relative errors
  std::vector<double> sums_;     ///< (groups of bars + 1) sum of squares before each group
  std::size_t right_sums_ = 0;   ///< how many of sums_ are up to date
  std::vector<std::uint8_t> off_;
  std::int64_t visits_ = 0;
};

}  // namespace pliant
