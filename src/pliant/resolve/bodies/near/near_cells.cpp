// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/near/near_cells.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr std::size_t cells_a_place = 8;
/// Angstrom: where a place has been that was moved. Nothing comes near it.
constexpr float nowhere = 1e8F;

std::uint32_t cells_along(double extent, double per_side) {
  return static_cast<std::uint32_t>(extent * per_side) + 1;
}

}  // namespace

void NearCells::sort(std::span<const Vec3> at) {
  set_cells(at);
  first_in_cell_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
  const std::span numbers(cell_number_), firsts(first_in_cell_);
  for (std::size_t k = 0; k < numbers.size(); ++k) ++firsts[numbers[k] + 1];
  for (std::size_t c = 1; c < firsts.size(); ++c) firsts[c] += firsts[c - 1];
  next_.assign(first_in_cell_.begin(), first_in_cell_.end() - 1);
  fill_cells(at);
}

/// Cells a little wider than the rules reach, and in which each place is.
void NearCells::set_cells(std::span<const Vec3> at) {
  const auto listed = rules_.listed();
  Vec3 high = low_ = at[listed[0]];
  for (Slot place : listed) {
    const Vec3 x = at[place];
    low_ = {std::min(low_.x, x.x), std::min(low_.y, x.y), std::min(low_.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  double side = rules_.largest() + skin_ + list_slack;
  const Vec3 extent = high - low_;
  const auto cell_count = [&] {
    per_side_ = 1.0 / side;
    cells_ = {cells_along(extent.x, per_side_), cells_along(extent.y, per_side_),
              cells_along(extent.z, per_side_)};
    return double(cells_[0]) * cells_[1] * cells_[2];
  };
  while (cell_count() > double(cells_a_place * listed.size() + 64)) side *= 1.25;
  cell_number_.resize(listed.size());
  for (std::size_t k = 0; k < listed.size(); ++k)
    cell_number_[k] = number_of(cell_of(at[listed[k]]));
}

/// Copies places side by side, cell by cell.
void NearCells::fill_cells(std::span<const Vec3> at) {
  const auto listed = rules_.listed();
  first_moved_ = listed.size();
  const std::size_t room = listed.size() + most_moved;
  for (auto* values : {&x_, &y_, &z_, &squares_}) values->resize(room + points_beyond);
  hits_.resize(room + hits_beyond);
  sorted_at_.resize(listed.size());
  index_of_.resize(at.size());
  const std::span next(next_), numbers(cell_number_);
  for (std::size_t k = 0; k < listed.size(); ++k) put(next[numbers[k]]++, listed[k], at[listed[k]]);
}

void NearCells::put(std::uint32_t to, Slot place, Vec3 at) {
  sorted_at_[to] = {place, rules_.kind(place)};
  index_of_[place] = to;
  x_[to] = static_cast<float>(at.x);
  y_[to] = static_cast<float>(at.y);
  z_[to] = static_cast<float>(at.z);
}

void NearCells::move(Slot place, Vec3 at) {
  std::uint32_t to = index_of_[place];
  if (to < first_moved_) {
    x_[to] = nowhere;
    to = static_cast<std::uint32_t>(sorted_at_.size());
    sorted_at_.push_back({});
  }
  put(to, place, at);
}

/// Begins the runs of a place: how far it is from the cells beside its own. It may lie outside.
void NearCells::start_runs(std::uint32_t k, Cell cell) {
  const double side = 1.0 / per_side_;
  const std::array<double, 3> at{x_[k] - low_.x, y_[k] - low_.y, z_[k] - low_.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double into = at[axis] - side * cell[axis];
    const double before = std::max(into, 0.0), after = std::max(side - into, 0.0);
    own_.squares[axis] = {before * before, 0.0, after * after};
  }
  own_.cell = cell;
  own_.widest = rules_.widest(sorted_at_[k].kind);
  run_count_ = 0;
}

/// The places within reach in the row of cells (a, b) from that of the place: side by side.
void NearCells::add_row(int a, int b) {
  const auto [x, y, z] = own_.cell;
  const std::uint32_t row_x = x + static_cast<std::uint32_t>(a),
                      row_y = y + static_cast<std::uint32_t>(b);  // below 0 they wrap around
  if (row_x >= cells_[0] || row_y >= cells_[1]) return;
  const double left =
      own_.widest - own_.squares[0][std::size_t(a + 1)] - own_.squares[1][std::size_t(b + 1)];
  if (left < 0.0) return;
  const std::uint32_t low = z > 0 && own_.squares[2][0] <= left ? z - 1 : z;
  const std::uint32_t high = z + 1 < cells_[2] && own_.squares[2][2] <= left ? z + 1 : z;
  const std::uint32_t row = (row_x * cells_[1] + row_y) * cells_[2];
  runs_[run_count_++] = {first_in_cell_[row + low], first_in_cell_[row + high + 1]};
}

/// What is in the cell of a place and half of its neighbours: the others are visited with it.
void NearCells::add_runs_after(std::uint32_t k, Cell cell) {
  start_runs(k, cell);
  add_row(0, 0);
  runs_[0].from = k + 1;
  add_row(0, 1);
  for (int b = -1; b <= 1; ++b) add_row(1, b);
}

/// What is in the cell of a place and all around it, and what was moved.
void NearCells::add_runs_around(std::uint32_t k, Cell cell) {
  start_runs(k, cell);
  for (int a = -1; a <= 1; ++a)
    for (int b = -1; b <= 1; ++b) add_row(a, b);
  if (moved() > 0)
    runs_[run_count_++] = {static_cast<std::uint32_t>(first_moved_),
                           static_cast<std::uint32_t>(sorted_at_.size())};
}

/// The places of the runs that are near the k-th, for their kinds, and not excluded by its mask.
std::span<const std::uint32_t> NearCells::find_free(std::uint32_t k) {
  const SortedPlace own = sorted_at_[k];
  float* const squares = squares_.data();
  std::uint32_t* const hits = hits_.data();
  const std::size_t near =
      find_near_hits_({x_.data(), y_.data(), z_.data()}, {runs_.data(), run_count_}, k,
                      rules_.widest(own.kind), squares, hits);
  const NeighbourMask excluded = rules_.excluded_near(own.place);  // itself, too
  const float* const reaches = rules_.square_reaches(own.kind);
  const SortedPlace* const sorted = sorted_at_.data();
  std::size_t count = 0;
  for (std::size_t h = 0; h < near; ++h) {
    const std::uint32_t m = hits[h];
    const SortedPlace other = sorted[m];
    const bool is_near = squares[m] < reaches[other.kind];
    hits[count] = m;
    count += static_cast<std::size_t>(is_near & !excluded.has(own.place, other.place));
  }
  return {hits, count};
}

}  // namespace pliant
