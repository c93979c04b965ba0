// SPDX-License-Identifier: MIT
// Places sorted into cells, to find near ones. Some may be moved afterwards without sorting all
// anew.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/bodies/near/near_hits.hpp"
#include "pliant/resolve/bodies/near/near_rules.hpp"

namespace pliant {

class NearCells {
 public:
  /// Largest number of moved places: they are in no cell, and each is compared with all of them.
  static constexpr std::size_t most_moved = 256;

  /// The rules must outlive it. `skin` (Angstrom) is that of the rules.
  NearCells(const NearRules& rules, double skin) : rules_(rules), skin_(skin) {}
  NearCells(const NearCells&) = delete;  // holds a reference to rules beside it
  NearCells& operator=(const NearCells&) = delete;

  /// Sorts all places that the rules list, at `at` (places).
  void sort(std::span<const Vec3> at);
  /// Moves a sorted place.
  void move(Slot place, Vec3 at);
  /// Number of places that were moved since all were sorted.
  std::size_t moved() const { return sorted_at_.size() - first_moved_; }

  /// Calls found(place, other) once for each pair that is within reach and not excluded by its
  /// mask. Only before any place was moved.
  template <class Found>
  void visit_all(const Found& found);
  /// The same for all pairs of one place.
  template <class Found>
  void visit(Slot place, const Found& found);

 private:
  struct SortedPlace {
    Slot place;
    std::uint16_t kind;
  };
  using Cell = std::array<std::uint32_t, 3>;

  void set_cells(std::span<const Vec3> at);
  void fill_cells(std::span<const Vec3> at);
  Cell cell_of(Vec3 at) const;
  std::uint32_t number_of(Cell cell) const;
  void put(std::uint32_t to, Slot place, Vec3 at);
  void start_runs(std::uint32_t k, Cell cell);
  void add_row(int a, int b);
  void add_runs_after(std::uint32_t k, Cell cell);
  void add_runs_around(std::uint32_t k, Cell cell);
  std::span<const std::uint32_t> find_free(std::uint32_t k);
  template <class Found>
  void tell(std::uint32_t k, const Found& found);

  const NearRules& rules_;
  double skin_;
  FindNearHits find_near_hits_ = near_hits_finders().back();
  Vec3 low_;
  double per_side_ = 1.0;  ///< of a cell, Angstrom^-1
  Cell cells_{};           ///< number along each axis
  std::vector<std::uint32_t> cell_number_, first_in_cell_, next_;
  // Places by cells, followed by those that were moved. The old entry of a moved place is put far
  // away, so that nothing finds it.
  std::vector<SortedPlace> sorted_at_;
  std::vector<float> x_, y_, z_;
  std::vector<std::uint32_t> index_of_;  ///< (places) index into these
  std::size_t first_moved_ = 0;
  /// Where the present place lies in its cell: what it is from the next ones (Angstrom).
  struct {
    Cell cell;
    std::array<std::array<double, 3>, 3> squares;  ///< of each axis, to the cells before, its own
                                                   ///< and after
    double widest;                                 ///< square of how far it may reach
  } own_{};
  // Candidates for one place as runs, and which of them are near.
  std::array<NearRun, 10> runs_{};
  std::size_t run_count_ = 0;
  std::vector<float> squares_;  ///< of distances to the present place
  std::vector<std::uint32_t> hits_;
};

/// The cell that contains `at`, or the nearest one if it is outside: a place outside all cells is
/// near only to those at the edge.
inline NearCells::Cell NearCells::cell_of(Vec3 at) const {
  const Vec3 from = per_side_ * (at - low_);
  const auto along = [](double x, std::uint32_t cells) {
    return std::min(x > 0.0 ? static_cast<std::uint32_t>(x) : 0U, cells - 1);
  };
  return {along(from.x, cells_[0]), along(from.y, cells_[1]), along(from.z, cells_[2])};
}

inline std::uint32_t NearCells::number_of(Cell cell) const {
  return (cell[0] * cells_[1] + cell[1]) * cells_[2] + cell[2];
}

template <class Found>
void NearCells::tell(std::uint32_t k, const Found& found) {
  const Slot own = sorted_at_[k].place;
  for (const std::uint32_t hit : find_free(k)) found(own, sorted_at_[hit].place);
}

template <class Found>
void NearCells::visit_all(const Found& found) {
  Cell cell{};
  for (cell[0] = 0; cell[0] < cells_[0]; ++cell[0])
    for (cell[1] = 0; cell[1] < cells_[1]; ++cell[1])
      for (cell[2] = 0; cell[2] < cells_[2]; ++cell[2]) {
        const std::uint32_t number = number_of(cell);
        const std::uint32_t first = first_in_cell_[number], last = first_in_cell_[number + 1];
        if (first == last) continue;
        for (std::uint32_t k = first; k < last; ++k) {
          add_runs_after(k, cell);
          tell(k, found);
        }
      }
}

template <class Found>
void NearCells::visit(Slot place, const Found& found) {
  const std::uint32_t k = index_of_[place];
  add_runs_around(k, cell_of({x_[k], y_[k], z_[k]}));
  tell(k, found);
}

}  // namespace pliant
