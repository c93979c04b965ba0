// SPDX-License-Identifier: MIT
#include "pliant/rigidity/pebble_game.hpp"

#include <algorithm>
#include <utility>

namespace pliant {

PebbleGame::PebbleGame(std::size_t bodies)
    : pebbles_(bodies, all_free), steps_(bodies), marks_(bodies, 0), has_bars_(bodies, false) {
  clusters_.reset(bodies);
}

std::uint32_t PebbleGame::add(std::uint32_t a, std::uint32_t b, std::uint32_t bars) {
  a = clusters_.find(a);
  b = clusters_.find(b);
  if (a == b || bars == 0) return 0;
  std::uint32_t independent = 0;
  if (!has_bars_[a] || !has_bars_[b]) {
    independent = std::min(bars, freedoms_of_body);
    has_bars_[b] ? hang_on(a, b, independent) : hang_on(b, a, independent);
  } else {
    for (; independent < bars && gather(a, b); ++independent) give_pebble(a, b);
    if (independent == freedoms_of_body) gather(a, b);  // fails, which makes them one
  }
  rank_ += independent;
  return independent;
}

bool PebbleGame::are_locked(std::uint32_t a, std::uint32_t b) {
  a = clusters_.find(a);
  b = clusters_.find(b);
  return a == b || !gather(a, b);
}

std::uint32_t PebbleGame::free_at(std::uint32_t body) const {
  return static_cast<std::uint32_t>(std::count(pebbles_[body].begin(), pebbles_[body].end(), free));
}

/// A body without bars pays itself for up to six: no search is needed. Most bonds of a molecule
/// come this way.
void PebbleGame::hang_on(std::uint32_t single, std::uint32_t other, std::uint32_t bars) {
  has_bars_[single] = true;
  has_bars_[other] = true;
  if (bars < freedoms_of_body) {
    std::fill_n(pebbles_[single].begin(), bars, other);
    return;
  }
  const Pebbles kept = pebbles_[other];
  clusters_.unite(single, other);
  pebbles_[clusters_.find(other)] = kept;
}

/// Brings seven pebbles to two bodies that are not one. If six is all there is, no bar leads out of
/// what was reached but to pebbles in use there: it is rigid, and becomes one body.
bool PebbleGame::gather(std::uint32_t a, std::uint32_t b) {
  while (free_at(a) + free_at(b) <= freedoms_of_body) {
    if (fetch_pebble(a, b)) continue;
    merge_reached();
    return false;
  }
  return true;
}

/// Looks for a free pebble along the bars that were paid for, the nearest first.
bool PebbleGame::fetch_pebble(std::uint32_t a, std::uint32_t b) {
  begin_search(a, b);
  for (std::size_t k = 0; k < reached_.size(); ++k) {
    const std::uint32_t body = reached_[k];
    for (std::uint32_t p = 0; p < freedoms_of_body; ++p) {
      if (pebbles_[body][p] == free) continue;
      const std::uint32_t to = clusters_.find(pebbles_[body][p]);
      if (marks_[to] == search_) continue;
      marks_[to] = search_;
      steps_[to] = {body, p};
      if (free_at(to) > 0) {
        carry_back(to);
        return true;
      }
      reached_.push_back(to);
    }
  }
  return false;
}

void PebbleGame::begin_search(std::uint32_t a, std::uint32_t b) {
  if (++search_ == 0) {  // after 2^32 searches marks would repeat
    std::fill(marks_.begin(), marks_.end(), 0);
    search_ = 1;
  }
  reached_.assign({a, b});
  for (const std::uint32_t end : {a, b}) {
    marks_[end] = search_;
    steps_[end].from = free;
  }
}

/// Each bar on the way back to the end where the search began is paid for by its other end.
void PebbleGame::carry_back(std::uint32_t body) {
  while (steps_[body].from != free) {
    const auto [from, pebble] = steps_[body];
    *std::find(pebbles_[body].begin(), pebbles_[body].end(), free) = from;
    pebbles_[from][pebble] = free;
    body = from;
  }
}

/// The end that has more pebbles pays.
void PebbleGame::give_pebble(std::uint32_t a, std::uint32_t b) {
  if (free_at(a) < free_at(b)) std::swap(a, b);
  *std::find(pebbles_[a].begin(), pebbles_[a].end(), free) = b;
}

void PebbleGame::merge_reached() {
  for (const std::uint32_t body : reached_) clusters_.unite(body, reached_.front());
  pebbles_[clusters_.find(reached_.front())] = all_free;
}

}  // namespace pliant
