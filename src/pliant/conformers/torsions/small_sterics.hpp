// SPDX-License-Identifier: MIT
// Overlaps of atoms of a small molecule, pair by pair: faster there than a neighbour list.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"

namespace pliant {

class SmallSterics {
 public:
  /// Has no pairs if the framework has no sterics or more than 300 joints.
  explicit SmallSterics(const Framework& framework);

  std::span<const NeighbourPair> pairs() const { return pairs_; }
  /// Sum of squared overlaps at `x` (N), Angstrom^2; of a part of them where that is `enough`.
  double overlap(std::span<const Vec3> x, double enough) const;

 private:
  std::vector<NeighbourPair> pairs_;
};

}  // namespace pliant
