// SPDX-License-Identifier: MIT
// Pairs of joints of different bodies that may come too near (Verlet list), in the numbering of a
// plan of bodies.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/near/near_cells.hpp"
#include "pliant/resolve/bodies/near/near_rules.hpp"

namespace pliant {

/// Two places i < j and their least distance (Angstrom).
struct NearPair {
  Slot i, j;
  double least;
};

/// The pairs that turn out too near depend neither on the skin nor on when the list was made. Each
/// place has its pairs listed at a position of its own: if few places have moved far, only the
/// pairs of these are listed anew. The first list is kept, for frames that begin where others did.
class NearPairs {
 public:
  /// Both must outlive it; the framework has sterics. `skin` (Angstrom): a place is listed anew
  /// before it has moved by more than half of it.
  NearPairs(const Framework& framework, const BodyPlan& plan, double skin = 0.5);

  /// Brings the list up to date for `x` (places, Angstrom, finite, within 1e4 of the origin).
  void update(std::span<const Vec3> x);
  std::span<const NearPair> pairs() const { return pairs_; }  ///< by i, then j
  std::int64_t lists_made() const { return lists_made_; }

 private:
  double furthest_from_listed(std::span<const Vec3> x);
  void make_first_list(std::span<const Vec3> x);
  bool is_back(std::span<const Vec3> x);
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
  std::vector<Vec3> listed_at_;           ///< (places) position when its pairs were listed
  std::vector<double> square_moves_;      ///< (places) since then
  std::vector<std::uint8_t> is_renewed_;  ///< (places)
  std::vector<Slot> renewed_;
  std::vector<NearPair> pairs_, unsorted_, sorted_, kept_;
  std::vector<Vec3> first_at_;  ///< (places) listed_at_ of the first list
  std::vector<NearPair> first_pairs_;
  bool are_cells_of_list_ = false;  ///< cells_ has places where they were listed
  std::vector<std::uint32_t> first_of_;
};

}  // namespace pliant
