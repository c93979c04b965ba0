// SPDX-License-Identifier: MIT
// Pairs of joints of different bodies that may come too near (Verlet list), in the numbering of a
// plan of bodies.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/grouped.hpp"
#include "pliant/framework/contacts.hpp"
#include "pliant/resolve/froda/body_plan.hpp"

namespace pliant {

/// Two places i < j and how near they may come (Angstrom).
struct NearPair {
  Slot i, j;
  double least;
};

/// Which pairs a caller finds too near depends neither on the skin nor on when the list was made.
class NearPairs {
 public:
  /// Both outlive it; the framework has sterics. `skin` (Angstrom): the list is made anew when a
  /// joint has moved by more than half of it.
  NearPairs(const Framework& framework, const BodyPlan& plan, double skin = 0.8);

  /// Makes the list right for `x` (places, Angstrom, finite, within 1e4 of the origin).
  void update(std::span<const Vec3> x);
  std::span<const NearPair> pairs() const { return pairs_; }  ///< by i, then j
  std::int64_t lists_made() const { return lists_made_; }

 private:
  struct Candidate {
    Slot i, j;
  };

  /// A pair whose distance is its own; 0: may come as near as it likes.
  struct Special {
    Slot other;
    double least;
  };
  void exclude();
  void set_reaches();
  bool is_out_of_date(std::span<const Vec3> x) const;
  void sort_into_cells(std::span<const Vec3> x);
  void visit_cell(std::uint32_t x, std::uint32_t y, std::uint32_t z);
  void gather_run(std::uint32_t row, std::uint32_t low, std::uint32_t high);
  void compare(std::size_t own);
  void take(Slot one, Slot other);
  double least_of(Slot i, Slot j) const;
  void sort_pairs();

  const BodyPlan& plan_;
  ContactRules rules_;
  const Sterics& sterics_;
  std::vector<std::uint64_t> near_excluded_;  ///< of each place: bit k: place + k + 1
  Grouped<Special> special_;                  ///< of each place, with higher ones
  std::vector<std::uint16_t> kind_;           ///< of each place, below kinds_
  std::size_t kinds_ = 0;
  std::vector<float> square_reaches_;  ///< (kinds * kinds) of the list, Angstrom^2
  float widest_ = 0.0F;                ///< largest of them
  std::vector<Slot> listed_;           ///< places that may touch others: no copies
  double skin_;
  std::int64_t lists_made_ = 0;
  std::vector<Vec3> listed_at_;
  std::vector<NearPair> pairs_, unsorted_;
  // while a list is made: places sorted into cells, and the candidates of the cell in hand
  std::array<std::uint32_t, 3> cells_{};
  std::vector<std::uint32_t> cell_of_, first_in_cell_, slot_;
  std::vector<float> x_, y_, z_;
  std::vector<float> near_x_, near_y_, near_z_, squares_;
  std::vector<Slot> near_;
  std::vector<std::uint32_t> hits_;
  std::vector<std::uint16_t> near_kind_, kind_at_;
  std::vector<std::uint32_t> first_of_, next_;
};

}  // namespace pliant
