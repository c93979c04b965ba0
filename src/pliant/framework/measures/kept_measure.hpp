// SPDX-License-Identifier: MIT
// Measures one walker again and again: what has not moved since is not measured anew.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/framework/measures/moved_blocks.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// Gives what measure() gives, bit for bit, whatever was measured before. Positions are compared
/// with those of the last call; where they are the same bits, so are the lengths. Not for two
/// threads at once.
class KeptMeasure {
 public:
  /// The framework outlives it.
  KeptMeasure(const Framework& framework, const Tolerance& tolerance);

  /// As measure() of these `positions` (N).
  ResidualSummary measure(std::span<const Vec3> positions, LimitsOff off = {});
  /// The same of bars and limits alone: overlaps are told as none.
  ResidualSummary measure_bars_and_limits(std::span<const Vec3> positions, LimitsOff off = {});

  /// Bars, limits and near pairs that were measured so far.
  std::int64_t visits() const { return visits_; }

 private:
  /// What a block of pairs has: where the largest is, of bars by their own length.
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
  Part part_of_bars(std::span<const Vec3> positions, std::size_t block);
  Part part_of_limits(std::span<const Vec3> positions, std::size_t block) const;
  Part part_of_overlaps(std::span<const Vec3> positions, std::size_t block) const;
  bool take_bars(ResidualSummary& summary) const;
  bool take_limits(ResidualSummary& summary) const;
  void take_overlaps(ResidualSummary& summary) const;
  double sum_of_squares();

  const Framework& framework_;
  Tolerance tolerance_;
  std::unique_ptr<Contacts> contacts_;  ///< null: no sterics
  std::int64_t lists_made_ = -1;        ///< of contacts_, when overlaps_ was assigned
  MovedChunks moved_;
  bool has_moved_ = true;  ///< since contacts_ looked
  PairBlocks bars_, limits_, overlaps_;
  std::vector<Part> bar_parts_, limit_parts_, overlap_parts_;
  std::vector<double> squares_;  ///< (bars) of relative errors
  std::vector<double> sums_;     ///< (blocks of bars + 1) of all squares before each
  std::size_t right_sums_ = 0;   ///< so many of them are
  std::vector<std::uint8_t> off_;
  std::int64_t visits_ = 0;
};

}  // namespace pliant
