// SPDX-License-Identifier: MIT
// Pairs of joints of different bodies that may come too near (Verlet list), in the numbering of a
// plan of bodies.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/froda/near_hits.hpp"
#include "pliant/resolve/froda/near_rules.hpp"

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
  struct SortedPlace {
    Slot place;
    std::uint16_t kind;
    std::uint8_t is_renewed;
  };

  double furthest_from_listed(std::span<const Vec3> x);
  bool choose_renewed(std::span<const Vec3> x);
  void make_list();
  void renew_list();
  void sort_into_cells();
  void set_cells();
  void fill_cells();
  template <class Visit>
  void visit_cells(const Visit& visit);
  void visit_cell(std::uint32_t x, std::uint32_t y, std::uint32_t z);
  void visit_renewed(std::uint32_t x, std::uint32_t y, std::uint32_t z);
  void add_run(std::uint32_t row, std::uint32_t low, std::uint32_t high);
  void compare(std::uint32_t first, std::uint32_t last);
  void compare_renewed(std::uint32_t first, std::uint32_t last);
  template <class IsWanted>
  void take_hits(std::uint32_t k, const IsWanted& is_wanted);
  std::size_t keep_free_hits(std::uint32_t k, std::size_t hit_count);
  void sort_pairs();

  NearRules rules_;
  FindNearHits find_near_hits_ = near_hits_finders().back();
  double skin_;
  std::size_t places_;
  std::int64_t lists_made_ = 0;
  std::vector<Vec3> listed_at_;  ///< where each place was when its pairs were listed
  std::vector<NearPair> pairs_, unsorted_, sorted_, kept_;
  std::vector<double> square_moves_;      ///< of each place since then
  std::vector<std::uint8_t> is_renewed_;  ///< of each place
  // while a list is made: places sorted into cells
  std::array<std::uint32_t, 3> cells_{};
  std::vector<std::uint32_t> cell_of_, first_in_cell_;
  std::vector<float> x_, y_, z_;
  std::vector<SortedPlace> sorted_at_;
  std::vector<std::uint8_t> is_renewed_cell_;
  // the candidates of the cell in hand, as runs of sorted places, and which are near the one in
  // hand
  std::array<NearRun, 9> runs_{};
  std::size_t run_count_ = 0;
  std::vector<float> squares_;  ///< of distances to the one in hand, of each sorted place
  std::vector<std::uint32_t> hits_;
  std::vector<std::uint32_t> first_of_, next_;
};

}  // namespace pliant
