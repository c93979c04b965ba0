// SPDX-License-Identifier: MIT
#include "pliant/resolve/froda/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr std::size_t cells_a_place = 8;
/// A place that has gone further than this share of the skin is listed anew as soon as any must be.
constexpr double renewed_share = 0.4;
/// Where more than this share of all places must be listed anew, all are.
constexpr double most_renewed = 0.7;

std::uint32_t cells_along(double extent, double side) {
  return static_cast<std::uint32_t>(extent / side) + 1;
}

}  // namespace

NearPairs::NearPairs(const Framework& framework, const BodyPlan& plan, double skin)
    : rules_(framework, plan, skin), skin_(skin), places_(plan.place_count()) {}

void NearPairs::update(std::span<const Vec3> x) {
  if (!(rules_.largest() > 0.0)) return;
  const bool is_first = listed_at_.empty();
  if (is_first) listed_at_.assign(x.begin(), x.end());
  if (!is_first && furthest_from_listed(x) <= 0.5 * skin_) return;
  const bool is_whole_list = choose_renewed(x) || is_first;
  ++lists_made_;
  unsorted_.clear();
  sort_into_cells();
  if (is_whole_list) return make_list();
  renew_list();
}

/// Notes how far each place has gone since its pairs were listed.
double NearPairs::furthest_from_listed(std::span<const Vec3> x) {
  square_moves_.resize(x.size());
  double furthest = 0.0;
  for (Slot place : rules_.listed()) {
    square_moves_[place] = norm_squared(x[place] - listed_at_[place]);
    furthest = std::max(furthest, square_moves_[place]);
  }
  return std::sqrt(furthest);
}

/// Those that have gone a good part of what they may. True if they are so many that all are.
bool NearPairs::choose_renewed(std::span<const Vec3> x) {
  const double least = renewed_share * skin_ * renewed_share * skin_;
  const auto listed = rules_.listed();
  is_renewed_.assign(x.size(), 0);
  square_moves_.resize(x.size());
  std::size_t count = 0;
  for (Slot place : listed) {
    is_renewed_[place] = square_moves_[place] > least ? 1 : 0;
    count += is_renewed_[place];
  }
  const bool is_all = double(count) > most_renewed * double(listed.size());
  for (Slot place : listed)
    if (is_all || is_renewed_[place] != 0) listed_at_[place] = x[place];
  return is_all;
}

template <class Visit>
void NearPairs::visit_cells(const Visit& visit) {
  for (std::uint32_t a = 0; a < cells_[0]; ++a)
    for (std::uint32_t b = 0; b < cells_[1]; ++b)
      for (std::uint32_t c = 0; c < cells_[2]; ++c) visit(a, b, c);
}

void NearPairs::make_list() {
  visit_cells([&](auto a, auto b, auto c) { visit_cell(a, b, c); });
  sort_pairs();
  pairs_.swap(unsorted_);
}

/// Lists the pairs of renewed places, and keeps those of the others.
void NearPairs::renew_list() {
  visit_cells([&](auto a, auto b, auto c) { visit_renewed(a, b, c); });
  sort_pairs();
  kept_.clear();
  for (const NearPair& pair : pairs_)
    if ((is_renewed_[pair.i] | is_renewed_[pair.j]) == 0) kept_.push_back(pair);
  pairs_.resize(kept_.size() + unsorted_.size());
  std::merge(kept_.begin(), kept_.end(), unsorted_.begin(), unsorted_.end(), pairs_.begin(),
             [](const NearPair& one, const NearPair& other) {
               return one.i != other.i ? one.i < other.i : one.j < other.j;
             });
}

/// Places where they were listed, by cells a little wider than the list reaches.
void NearPairs::sort_into_cells() {
  set_cells();
  first_in_cell_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
  is_renewed_cell_.assign(first_in_cell_.size(), 0);
  const auto listed = rules_.listed();
  const std::span cells(cell_of_), firsts(first_in_cell_);
  const std::span of_place(is_renewed_), of_cell(is_renewed_cell_);
  for (std::size_t k = 0; k < listed.size(); ++k) {
    ++firsts[cells[k] + 1];
    of_cell[cells[k]] |= of_place[listed[k]];
  }
  for (std::size_t c = 1; c < firsts.size(); ++c) firsts[c] += firsts[c - 1];
  next_.assign(first_in_cell_.begin(), first_in_cell_.end() - 1);
  fill_cells();
}

/// How many cells there are, and in which each place is.
void NearPairs::set_cells() {
  const auto listed = rules_.listed();
  Vec3 low = listed_at_[listed[0]], high = low;
  for (Slot place : listed) {
    const Vec3 at = listed_at_[place];
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  double side = rules_.largest() + skin_ + list_slack;
  const Vec3 extent = high - low;
  const auto cell_count = [&] {
    cells_ = {cells_along(extent.x, side), cells_along(extent.y, side),
              cells_along(extent.z, side)};
    return double(cells_[0]) * cells_[1] * cells_[2];
  };
  while (cell_count() > double(cells_a_place * listed.size() + 64)) side *= 1.25;
  cell_of_.resize(listed.size());
  const double per_side = 1.0 / side;
  const std::array<std::uint32_t, 3> cells = cells_;
  const std::span cell_of(cell_of_);
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const Vec3 at = per_side * (listed_at_[listed[k]] - low);
    cell_of[k] = (static_cast<std::uint32_t>(at.x) * cells[1] + static_cast<std::uint32_t>(at.y)) *
                     cells[2] +
                 static_cast<std::uint32_t>(at.z);
  }
}

/// Copies places side by side, cell by cell.
void NearPairs::fill_cells() {
  const auto listed = rules_.listed();
  for (auto* values : {&x_, &y_, &z_, &squares_}) values->resize(listed.size() + points_beyond);
  sorted_at_.resize(listed.size());
  hits_.resize(listed.size() + hits_beyond);
  const std::span next(next_), cell_of(cell_of_);
  const std::span x(x_), y(y_), z(z_);
  const std::span sorted(sorted_at_);
  for (std::size_t k = 0; k < listed.size(); ++k) {
    const std::uint32_t to = next[cell_of[k]]++;
    const Slot place = listed[k];
    const Vec3 at = listed_at_[place];
    sorted[to] = {place, rules_.kind(place), is_renewed_[place]};
    x[to] = static_cast<float>(at.x);
    y[to] = static_cast<float>(at.y);
    z[to] = static_cast<float>(at.z);
  }
}

/// Pairs within a cell, and between it and half of its neighbours: the others visit it.
void NearPairs::visit_cell(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t row = (a * cells_[1] + b) * cells_[2];
  const std::uint32_t first = first_in_cell_[row + c], last = first_in_cell_[row + c + 1];
  if (first == last) return;
  run_count_ = 0;
  const std::uint32_t low = c > 0 ? c - 1 : 0, high = std::min(c + 1, cells_[2] - 1);
  add_run(row, c, high);
  const bool has_next = a + 1 < cells_[0];
  if (b + 1 < cells_[1]) add_run(row + cells_[2], low, high);
  if (has_next && b > 0) add_run(row + (cells_[1] - 1) * cells_[2], low, high);
  if (has_next) add_run(row + cells_[1] * cells_[2], low, high);
  if (has_next && b + 1 < cells_[1]) add_run(row + (cells_[1] + 1) * cells_[2], low, high);
  compare(first, last);
}

/// Pairs of renewed places of a cell with all in it and around it.
void NearPairs::visit_renewed(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t cell = (a * cells_[1] + b) * cells_[2] + c;
  if (is_renewed_cell_[cell] == 0) return;
  const std::uint32_t first = first_in_cell_[cell], last = first_in_cell_[cell + 1];
  run_count_ = 0;
  const std::uint32_t low = c > 0 ? c - 1 : 0, high = std::min(c + 1, cells_[2] - 1);
  for (std::uint32_t x = a > 0 ? a - 1 : 0; x <= std::min(a + 1, cells_[0] - 1); ++x)
    for (std::uint32_t y = b > 0 ? b - 1 : 0; y <= std::min(b + 1, cells_[1] - 1); ++y)
      add_run((x * cells_[1] + y) * cells_[2], low, high);
  compare_renewed(first, last);
}

/// The places in cells low..high of a row, which lie side by side.
void NearPairs::add_run(std::uint32_t row, std::uint32_t low, std::uint32_t high) {
  runs_[run_count_++] = {first_in_cell_[row + low], first_in_cell_[row + high + 1]};
}

/// Each of the places [first, last), with which the first run begins, with all after it.
void NearPairs::compare(std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t k = first; k < last; ++k) {
    runs_[0].from = k + 1;
    take_hits(k, [](const SortedPlace&) { return true; });
  }
}

/// The renewed ones of [first, last) with all; of two renewed ones the lower takes both.
void NearPairs::compare_renewed(std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t k = first; k < last; ++k) {
    if (sorted_at_[k].is_renewed == 0) continue;
    const Slot own = sorted_at_[k].place;
    take_hits(k, [own](const SortedPlace& m) { return m.is_renewed == 0 || own < m.place; });
  }
}

/// Lists those of the runs that may come too near to the k-th of the sorted places.
template <class IsWanted>
void NearPairs::take_hits(std::uint32_t k, const IsWanted& is_wanted) {
  const NearPoints points{x_.data(), y_.data(), z_.data()};
  const std::size_t hits =
      find_near_hits_(points, {runs_.data(), run_count_}, k, rules_.widest(sorted_at_[k].kind),
                      squares_.data(), hits_.data());
  const Slot own = sorted_at_[k].place;
  for (std::size_t h = 0, count = keep_free_hits(k, hits); h < count; ++h) {
    const SortedPlace& hit = sorted_at_[hits_[h]];
    if (!is_wanted(hit)) continue;
    const Slot i = std::min(own, hit.place), j = std::max(own, hit.place);
    if (const double least = rules_.least(i, j); least > 0.0) unsorted_.push_back({i, j, least});
  }
}

/// Of the hits of a sorted place those that are not excluded and near for their kinds; how many.
std::size_t NearPairs::keep_free_hits(std::uint32_t k, std::size_t hit_count) {
  const SortedPlace own = sorted_at_[k];
  const NeighbourMask excluded = rules_.excluded_near(own.place);
  const float *const reaches = rules_.square_reaches(own.kind), *const squares = squares_.data();
  const SortedPlace* const sorted = sorted_at_.data();
  std::uint32_t* const hits = hits_.data();
  std::size_t count = 0;
  for (std::size_t h = 0; h < hit_count; ++h) {
    const std::uint32_t m = hits[h];
    const SortedPlace other = sorted[m];
    const bool is_near = squares[m] < reaches[other.kind];
    hits[count] = m;
    count += static_cast<std::size_t>(is_near & !excluded.has(own.place, other.place));
  }
  return count;
}

/// What was found, by i, then j: two passes of counting.
void NearPairs::sort_pairs() {
  sorted_.resize(unsorted_.size());
  const auto pass = [&](auto key, std::span<const NearPair> from, std::span<NearPair> to) {
    first_of_.assign(places_ + 1, 0);
    for (const NearPair& pair : from) ++first_of_[key(pair) + 1];
    for (std::size_t k = 0; k < places_; ++k) first_of_[k + 1] += first_of_[k];
    for (const NearPair& pair : from) to[first_of_[key(pair)]++] = pair;
  };
  pass([](const NearPair& pair) { return pair.j; }, unsorted_, sorted_);
  pass([](const NearPair& pair) { return pair.i; }, sorted_, unsorted_);
}

}  // namespace pliant
