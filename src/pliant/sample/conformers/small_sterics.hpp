// SPDX-License-Identifier: MIT
// How deep atoms of a small molecule overlap, pair by pair: quicker than a list of neighbours
// there.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/contacts.hpp"

namespace pliant {

class SmallSterics {
 public:
  /// Of a framework without sterics, or of more than 300 joints, nothing is looked at.
  explicit SmallSterics(const Framework& framework);

  std::span<const Contact> pairs() const { return pairs_; }
  /// Sum of squares of depths at `x` (N), Angstrom^2.
  double overlap(std::span<const Vec3> x) const;

 private:
  std::vector<Contact> pairs_;
};

}  // namespace pliant
