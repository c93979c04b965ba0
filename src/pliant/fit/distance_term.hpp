// SPDX-License-Identifier: MIT
// Measured distances as a term of a fit: intervals that pull where they are violated.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "pliant/fit/fit_term.hpp"
#include "pliant/fit/residue_sites.hpp"

namespace pliant {

/// What is known of the distance of two sites.
struct FitDistance {
  std::uint32_t a = 0, b = 0;                                        ///< indices of sites
  double low = 0.0, high = std::numeric_limits<double>::infinity();  ///< Angstrom
  /// So many of the next ones say of which other sites it may be: the interval is that of
  /// (sum of r^-6)^(-1/6), as of an ambiguous NOE (M. Nilges, Proteins 17 (1993) 297).
  std::uint32_t more = 0;
};

/// How far a distance is outside of its interval: above 0 where it is too long (Angstrom).
double outside(const FitDistance& datum, double distance);

/// w u^2 of each violation u, with the weights w of the stages. Which data cannot hold with the
/// others is not decided here: fits without them tell.
class DistanceTerm : public FitTerm {
 public:
  /// Both must outlive it.
  DistanceTerm(std::span<const FitDistance> data, const ResidueSites& sites)
      : data_(data), sites_(sites) {}
  void begin(std::size_t stage, std::span<const Vec3> nodes) override;
  double add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const override;

 private:
  double add_one(std::span<const FitDistance> same, std::span<const Vec3> places,
                 std::span<Vec3> slopes) const;

  std::span<const FitDistance> data_;
  const ResidueSites& sites_;
  double weight_ = 0.0;
};

}  // namespace pliant
