// SPDX-License-Identifier: MIT
// Pairs of joints of different bodies that may come too near (Verlet list), in the numbering of a
// plan of bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/froda/near/near_cells.hpp"
#include "pliant/resolve/froda/near/near_rules.hpp"

namespace pliant {

/// Two places i < j and how near they may come (Angstrom).
struct NearPair {
  Slot i, j;
  double least;
};

/// Which pairs a caller finds too near depends neither on the skin nor on when the list was made.
/// Each place has its pairs listed where it was last looked at: where few have gone far, the pairs
/// of these alone are listed anew.
class NearPairs {
 public:
  /// Both outlive it; the framework has sterics. `skin` (Angstrom): a place is listed anew before
  /// it has moved by more than half of it.
  NearPairs(const Framework& framework, const BodyPlan& plan, double skin = 0.5);

  /// Makes the list right for `x` (places, Angstrom, finite, within 1e4 of the origin).
  void update(std::span<const Vec3> x);
  std::span<const NearPair> pairs() const { return pairs_; }  ///< by i, then j
  std::int64_t lists_made() const { return lists_made_; }

 private:
  double furthest_from_listed(std::span<const Vec3> x);
  void choose_renewed();
  void make_list(std::span<const Vec3> x);
  void renew_list(std::span<const Vec3> x);
  void take(Slot one, Slot other);
  void sort_pairs();

  NearRules rules_;
  NearCells cells_;
  double skin_;
  std::size_t places_;
  std::int64_t lists_made_ = 0;
  std::vector<Vec3> listed_at_;           ///< where each place was when its pairs were listed
  std::vector<double> square_moves_;      ///< of each place since then
  std::vector<std::uint8_t> is_renewed_;  ///< of each place
  std::vector<Slot> renewed_;
  std::vector<NearPair> pairs_, unsorted_, sorted_, kept_;
  std::vector<std::uint32_t> first_of_;
};

}  // namespace pliant
