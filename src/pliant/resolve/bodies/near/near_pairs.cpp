// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/near/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

/// A place that has gone further than this share of the skin is listed anew as soon as any must be.
constexpr double renewed_share = 0.4;
/// Where more than this share of all places must be listed anew, all are.
constexpr double most_renewed = 0.7;

}  // namespace

NearPairs::NearPairs(const Framework& framework, const BodyPlan& plan, double skin)
    : rules_(framework, plan, skin),
      cells_(rules_, skin),
      skin_(skin),
      places_(plan.place_count()) {}

void NearPairs::update(std::span<const Vec3> x) {
  if (!(rules_.largest() > 0.0)) return;
  if (listed_at_.empty()) return make_first_list(x);
  if (furthest_from_listed(x) <= 0.5 * skin_ || is_back(x)) return;
  choose_renewed();
  ++lists_made_;
  unsorted_.clear();
  if (double(renewed_.size()) > most_renewed * double(rules_.listed().size())) return make_list(x);
  renew_list(x);
}

void NearPairs::make_first_list(std::span<const Vec3> x) {
  listed_at_.assign(x.begin(), x.end());
  ++lists_made_;
  make_list(x);
  first_at_ = listed_at_;
  first_pairs_ = pairs_;
}

/// Takes the first list again where all places are back.
bool NearPairs::is_back(std::span<const Vec3> x) {
  const double most = 0.25 * skin_ * skin_;
  const auto listed = rules_.listed();
  if (!std::all_of(listed.begin(), listed.end(),
                   [&](Slot k) { return norm_squared(x[k] - first_at_[k]) <= most; }))
    return false;
  listed_at_ = first_at_;
  pairs_ = first_pairs_;
  are_cells_of_list_ = false;
  return true;
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

/// Chooses the joints that have gone a good part of the way they may.
void NearPairs::choose_renewed() {
  const double least = renewed_share * skin_ * renewed_share * skin_;
  is_renewed_.assign(places_, 0);
  renewed_.clear();
  for (Slot place : rules_.listed()) {
    if (!(square_moves_[place] > least)) continue;
    is_renewed_[place] = 1;
    renewed_.push_back(place);
  }
}

void NearPairs::make_list(std::span<const Vec3> x) {
  for (Slot place : rules_.listed()) listed_at_[place] = x[place];
  cells_.sort(listed_at_);
  are_cells_of_list_ = true;
  cells_.visit_all([&](Slot one, Slot other) { take(one, other); });
  sort_pairs();
  pairs_.swap(unsorted_);
}

/// Lists the pairs of renewed places, and keeps those of the others.
void NearPairs::renew_list(std::span<const Vec3> x) {
  for (Slot place : renewed_) listed_at_[place] = x[place];
  if (!are_cells_of_list_ || cells_.moved() + renewed_.size() > NearCells::most_moved) {
    cells_.sort(listed_at_);
    are_cells_of_list_ = true;
  } else {
    for (Slot place : renewed_) cells_.move(place, listed_at_[place]);
  }
  for (Slot place : renewed_)  // of two renewed ones the lower takes both
    cells_.visit(place, [&](Slot one, Slot other) {
      if (is_renewed_[other] == 0 || one < other) take(one, other);
    });
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

void NearPairs::take(Slot one, Slot other) {
  const Slot i = std::min(one, other), j = std::max(one, other);
  if (const double least = rules_.least(i, j); least > 0.0) unsorted_.push_back({i, j, least});
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
