// SPDX-License-Identifier: MIT
// R.m.s.d. between conformers of one molecule: heavy atoms, superposed, the least over the
// molecule's symmetries.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/conformers/choice/symmetries.hpp"

namespace pliant {

class ShapeDistances {
 public:
  /// `symmetries` must outlive it.
  explicit ShapeDistances(const Symmetries& symmetries) : symmetries_(symmetries) {}

  /// Adds a conformer (N, Angstrom).
  void add(std::span<const Vec3> x);
  std::size_t size() const { return squares_.size(); }

  /// Angstrom, between two conformers by their numbers; infinite if it is more than `reach`, which
  /// is mostly found without superposing them.
  double between(std::size_t one, std::size_t other, double reach = HUGE_VAL) const;

 private:
  bool may_be_within(std::size_t one, std::size_t other, const std::vector<std::uint32_t>& map,
                     double mean_square) const;
  double mean_square(std::size_t one, std::size_t other,
                     const std::vector<std::uint32_t>& map) const;
  std::span<const Vec3> heavy(std::size_t conformer) const;

  const Symmetries& symmetries_;
  std::vector<Vec3> heavy_;      ///< (conformers * n) from their centre
  std::vector<double> radii_;    ///< (conformers * n) distances from it
  std::vector<double> squares_;  ///< (conformers) sums of squares of these
};

}  // namespace pliant
