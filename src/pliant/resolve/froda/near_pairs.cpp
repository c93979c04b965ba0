// SPDX-License-Identifier: MIT
#include "pliant/resolve/froda/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr Slot bits = 64;
/// Angstrom: a list reaches a little further than it must, for it looks at rounded positions.
constexpr double slack = 0.01;
constexpr std::size_t cells_a_place = 8;

std::uint32_t cells_along(double extent, double side) {
  return static_cast<std::uint32_t>(extent / side) + 1;
}

}  // namespace

NearPairs::NearPairs(const Framework& framework, const BodyPlan& plan, double skin)
    : plan_(plan),
      rules_(framework),
      sterics_(*framework.sterics()),
      near_excluded_(plan.place_count(), 0),
      kind_(plan.place_count(), 0),
      kinds_(sterics_.kind_count),
      skin_(skin) {
  for (Slot place = 0; place < plan.place_count(); ++place)
    if (plan.place_of(plan.joint_at()[place]) == place) listed_.push_back(place);
  for (Slot place : listed_) kind_[place] = sterics_.kinds[plan.joint_at()[place]];
  exclude();
  set_reaches();
}

/// Pairs that are few bonds apart: a bit each where their places are near, else as pairs with
/// distances of their own.
void NearPairs::exclude() {
  std::vector<std::pair<Slot, Special>> found;
  const auto pair_of = [&](Joint a, Joint b) {
    const Slot one = plan_.place_of(a), other = plan_.place_of(b);
    return std::pair(std::min(one, other), std::max(one, other));
  };
  for (Slot place : listed_) {
    const Joint joint = plan_.joint_at()[place];
    for (Joint other : rules_.excluded_above(joint)) {
      const auto [low, high] = pair_of(joint, other);
      if (high - low <= bits) {
        near_excluded_[low] |= std::uint64_t{1} << (high - low - 1);
      } else {
        found.push_back({low, {high, 0.0}});
      }
    }
  }
  for (const OwnDistance& own : sterics_.own) {
    const auto [low, high] = pair_of(own.a, own.b);
    if (high - low <= bits) near_excluded_[low] &= ~(std::uint64_t{1} << (high - low - 1));
    found.insert(found.begin(), {low, {high, own.least}});
  }
  special_ = Grouped<Special>(plan_.place_count(), [&](const auto& put) {
    for (const auto& [low, special] : found) put(low, special);
  });
}

/// How far the list reaches for each two kinds; as far as for any where a pair's own distance is
/// above that of its kinds.
void NearPairs::set_reaches() {
  const bool is_beyond = std::any_of(sterics_.own.begin(), sterics_.own.end(), [&](auto& own) {
    return own.least > sterics_.of_kinds(own.a, own.b);
  });
  for (double least : sterics_.least) {
    const double reach = (is_beyond ? rules_.largest() : least) + skin_ + slack;
    square_reaches_.push_back(least > 0.0 || is_beyond ? static_cast<float>(reach * reach) : 0.0F);
    widest_ = std::max(widest_, square_reaches_.back());
  }
}

void NearPairs::update(std::span<const Vec3> x) {
  if (!(rules_.largest() > 0.0) || !is_out_of_date(x)) return;
  ++lists_made_;
  listed_at_.assign(x.begin(), x.end());
  unsorted_.clear();
  sort_into_cells(x);
  for (std::uint32_t a = 0; a < cells_[0]; ++a)
    for (std::uint32_t b = 0; b < cells_[1]; ++b)
      for (std::uint32_t c = 0; c < cells_[2]; ++c) visit_cell(a, b, c);
  sort_pairs();
}

bool NearPairs::is_out_of_date(std::span<const Vec3> x) const {
  if (listed_at_.empty()) return true;
  const double most = 0.25 * skin_ * skin_;
  double furthest = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k)
    furthest = std::max(furthest, norm_squared(x[k] - listed_at_[k]));
  return furthest > most;
}

void NearPairs::sort_into_cells(std::span<const Vec3> x) {
  Vec3 low = x[listed_[0]], high = low;
  for (Slot place : listed_) {
    const Vec3 at = x[place];
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  double side = rules_.largest() + skin_ + slack;
  const Vec3 extent = high - low;
  const auto set_cells = [&] {
    cells_ = {cells_along(extent.x, side), cells_along(extent.y, side),
              cells_along(extent.z, side)};
    return double(cells_[0]) * cells_[1] * cells_[2];
  };
  while (set_cells() > double(cells_a_place * listed_.size() + 64)) side *= 1.25;
  cell_of_.resize(listed_.size());
  first_in_cell_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
  for (std::size_t k = 0; k < listed_.size(); ++k) {
    const Vec3 at = (1.0 / side) * (x[listed_[k]] - low);
    cell_of_[k] =
        (static_cast<std::uint32_t>(at.x) * cells_[1] + static_cast<std::uint32_t>(at.y)) *
            cells_[2] +
        static_cast<std::uint32_t>(at.z);
    ++first_in_cell_[cell_of_[k] + 1];
  }
  for (std::size_t c = 1; c < first_in_cell_.size(); ++c)
    first_in_cell_[c] += first_in_cell_[c - 1];
  next_.assign(first_in_cell_.begin(), first_in_cell_.end() - 1);
  for (auto* values : {&x_, &y_, &z_}) values->resize(listed_.size());
  slot_.resize(listed_.size());
  kind_at_.resize(listed_.size());
  for (std::size_t k = 0; k < listed_.size(); ++k) {
    const std::uint32_t slot = next_[cell_of_[k]]++;
    const Vec3 at = x[listed_[k]];
    slot_[slot] = listed_[k];
    kind_at_[slot] = kind_[listed_[k]];
    x_[slot] = static_cast<float>(at.x);
    y_[slot] = static_cast<float>(at.y);
    z_[slot] = static_cast<float>(at.z);
  }
}

/// Pairs within a cell, and between it and half of its neighbours: the others visit it.
void NearPairs::visit_cell(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const std::uint32_t row = (a * cells_[1] + b) * cells_[2];
  const std::size_t own = first_in_cell_[row + c + 1] - first_in_cell_[row + c];
  if (own == 0) return;
  near_.clear();
  near_kind_.clear();
  near_x_.clear();
  near_y_.clear();
  near_z_.clear();
  const std::uint32_t low = c > 0 ? c - 1 : 0, high = std::min(c + 1, cells_[2] - 1);
  gather_run(row, c, high);
  const bool has_next = a + 1 < cells_[0];
  if (b + 1 < cells_[1]) gather_run(row + cells_[2], low, high);
  if (has_next && b > 0) gather_run(row + (cells_[1] - 1) * cells_[2], low, high);
  if (has_next) gather_run(row + cells_[1] * cells_[2], low, high);
  if (has_next && b + 1 < cells_[1]) gather_run(row + (cells_[1] + 1) * cells_[2], low, high);
  compare(own);
}

/// Appends the places in cells low..high of a row.
void NearPairs::gather_run(std::uint32_t row, std::uint32_t low, std::uint32_t high) {
  const auto from = std::ptrdiff_t(first_in_cell_[row + low]);
  const auto to = std::ptrdiff_t(first_in_cell_[row + high + 1]);
  near_.insert(near_.end(), slot_.begin() + from, slot_.begin() + to);
  near_kind_.insert(near_kind_.end(), kind_at_.begin() + from, kind_at_.begin() + to);
  near_x_.insert(near_x_.end(), x_.begin() + from, x_.begin() + to);
  near_y_.insert(near_y_.end(), y_.begin() + from, y_.begin() + to);
  near_z_.insert(near_z_.end(), z_.begin() + from, z_.begin() + to);
}

/// Each of the first `own` candidates with all after it.
void NearPairs::compare(std::size_t own) {
  const std::size_t count = near_.size();
  squares_.resize(count);
  hits_.resize(count);
  const float *px = near_x_.data(), *py = near_y_.data(), *pz = near_z_.data();
  float* square = squares_.data();
  for (std::size_t k = 0; k < own; ++k) {
    const float ax = px[k], ay = py[k], az = pz[k];
    for (std::size_t m = k + 1; m < count; ++m) {
      const float dx = px[m] - ax, dy = py[m] - ay, dz = pz[m] - az;
      square[m] = dx * dx + dy * dy + dz * dz;
    }
    const float* reaches = square_reaches_.data() + near_kind_[k] * kinds_;
    std::size_t hits = 0;
    for (std::size_t m = k + 1; m < count; ++m) {  // no branch: which are near is anyone's guess
      hits_[hits] = static_cast<std::uint32_t>(m);
      hits += square[m] < widest_ ? 1 : 0;
    }
    for (std::size_t h = 0; h < hits; ++h)
      if (square[hits_[h]] < reaches[near_kind_[hits_[h]]]) take(near_[k], near_[hits_[h]]);
  }
}

void NearPairs::take(Slot one, Slot other) {
  const Slot i = std::min(one, other), j = std::max(one, other);
  const auto body_at = plan_.body_at();
  if (body_at[i] == body_at[j]) return;
  if (j - i <= bits && (near_excluded_[i] >> (j - i - 1) & 1) != 0) return;
  const double least = least_of(i, j);
  if (least > 0.0) unsorted_.push_back({i, j, least});
}

double NearPairs::least_of(Slot i, Slot j) const {
  for (const Special& special : special_.at(i))
    if (special.other == j) return special.least;
  const auto& units = sterics_.units;
  const Joint a = plan_.joint_at()[i], b = plan_.joint_at()[j];
  if (!units.empty() && units[a] == units[b] && units[a] != no_unit) return 0.0;
  return sterics_.least[kind_[i] * kinds_ + kind_[j]];
}

/// By i, then j: two passes of counting.
void NearPairs::sort_pairs() {
  const std::size_t places = plan_.place_count();
  pairs_.resize(unsorted_.size());
  const auto pass = [&](auto key, std::span<const NearPair> from, std::span<NearPair> to) {
    first_of_.assign(places + 1, 0);
    for (const NearPair& pair : from) ++first_of_[key(pair) + 1];
    for (std::size_t k = 0; k < places; ++k) first_of_[k + 1] += first_of_[k];
    for (const NearPair& pair : from) to[first_of_[key(pair)]++] = pair;
  };
  pass([](const NearPair& pair) { return pair.j; }, unsorted_, pairs_);
  unsorted_.swap(pairs_);
  pass([](const NearPair& pair) { return pair.i; }, unsorted_, pairs_);
}

}  // namespace pliant
