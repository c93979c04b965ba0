// SPDX-License-Identifier: MIT
// The pebble game that counts the freedoms of bodies joined by bars (body-bar framework).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/base/graphs/disjoint_sets.hpp"

namespace pliant {

/// Degrees of freedom of a rigid body in space.
inline constexpr std::uint32_t freedoms_of_body = 6;

/// The (6,6) pebble game (Lee, Streinu, Discrete Math. 308 (2008) 1425; Jacobs, Hendrickson, J.
/// Comput. Phys. 137 (1997) 346). Each body has six pebbles, its freedoms; a bar takes one of them
/// if it is independent of the bars before it. It is independent exactly if seven pebbles can be
/// gathered at its two ends, that is, if the ends are not rigid against each other yet. For bars in
/// general directions that is the rank of the rigidity matrix (Tay, J. Combin. Theory B 36 (1984)
/// 95).
///
/// Bodies that are found to be rigid against each other are merged into one with six pebbles, so
/// that no search goes through them again. Memory is linear in the number of bodies, whatever the
/// number of bars; time is nearly linear if pebbles are near, as in molecules. Deterministic.
class PebbleGame {
 public:
  explicit PebbleGame(std::size_t bodies);

  /// Puts `bars` bars between two bodies. Returns how many of them are independent of all earlier
  /// bars.
  std::uint32_t add(std::uint32_t a, std::uint32_t b, std::uint32_t bars);

  /// Whether two bodies are rigid against each other. If so, they are merged.
  bool are_locked(std::uint32_t a, std::uint32_t b);

  /// The lowest body among those known to be rigid with `body`. Once are_locked() has been asked
  /// for the ends of every edge, these are the rigid clusters.
  std::uint32_t cluster_of(std::uint32_t body) { return clusters_.find(body); }

  /// Independent bars so far: the rank of the rigidity matrix.
  std::size_t rank() const { return rank_; }

 private:
  static constexpr std::uint32_t free = ~std::uint32_t{0};
  /// For each pebble of a body the body at the other end of its bar; `free` if the pebble is not
  /// used.
  using Pebbles = std::array<std::uint32_t, freedoms_of_body>;
  /// The body from which a search came, and the pebble that it followed.
  struct Step {
    std::uint32_t from = free;
    std::uint32_t pebble = 0;
  };

  static constexpr Pebbles all_free{free, free, free, free, free, free};

  std::uint32_t free_at(std::uint32_t body) const;
  void hang_on(std::uint32_t a, std::uint32_t b, std::uint32_t bars);
  bool gather(std::uint32_t a, std::uint32_t b);
  bool fetch_pebble(std::uint32_t a, std::uint32_t b);
  void begin_search(std::uint32_t a, std::uint32_t b);
  void carry_back(std::uint32_t body);
  void give_pebble(std::uint32_t a, std::uint32_t b);
  void merge_reached();

  DisjointSets clusters_;
  std::vector<Pebbles> pebbles_;      ///< (bodies) valid for the lowest body of each cluster
  std::vector<Step> steps_;           ///< (bodies) of the current search
  std::vector<std::uint32_t> marks_;  ///< (bodies) number of the last search that reached it
  std::vector<bool> has_bars_;        ///< (bodies)
  std::vector<std::uint32_t> reached_;
  std::uint32_t search_ = 0;
  std::size_t rank_ = 0;
};

}  // namespace pliant
