// SPDX-License-Identifier: MIT
// Neighbour lists joint by joint (Verlet lists), kept up to date for those joints alone that move.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/measures/neighbour_list.hpp"

namespace pliant {

/// A joint that may come too near to another, and their least distance.
struct NearJoint {
  Joint joint;
  double least;  ///< Angstrom
};

/// Each joint has its neighbours listed at a place of its own, with a skin: it is listed anew when
/// it is looked at more than half a skin away. Which pairs are found to overlap depends neither on
/// the skin nor on the history; the order within a list does. Not thread-safe.
class JointNeighbours {
 public:
  /// The framework must have sterics, and outlive this. `skin` in Angstrom, above 0.
  explicit JointNeighbours(const Framework& framework, double skin = 0.6);

  /// Lists all joints at `positions` (N, Angstrom). Returns false if a position is not finite or
  /// further than 1e9 Angstrom from the origin.
  bool start(std::span<const Vec3> positions);
  /// Says that a joint is at `x` now; `x` as start() takes it, else it is ignored.
  void look(Joint joint, Vec3 x);
  /// All joints that may overlap with one, and some others, if all were looked at where they are.
  std::span<const NearJoint> near(Joint joint) const { return near_[joint]; }

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};

  std::size_t bucket_at(std::int64_t i, std::int64_t j, std::int64_t k) const;
  std::size_t bucket_of(Vec3 x) const;
  void put(Joint joint, Vec3 x);
  void take_out(Joint joint);
  template <class Visit>
  void visit_around(Vec3 x, const Visit& visit) const;
  double least_of(Joint a, Joint b) const;
  void list(Joint joint);
  void unlist(Joint joint);

  LeastDistances rules_;
  double skin_, edge_;
  std::vector<std::uint32_t> first_;        ///< (buckets) a joint, or none
  std::vector<std::uint32_t> next_, last_;  ///< (N) in the same bucket
  std::vector<Vec3> listed_at_;             ///< (N)
  std::vector<std::vector<NearJoint>> near_;
};

}  // namespace pliant
