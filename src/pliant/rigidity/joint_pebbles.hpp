// SPDX-License-Identifier: MIT
// The pebble game that counts the freedoms of joints held by bars (bar-and-joint framework).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// The (2,3) pebble game in the plane, the (3,6) game in space (Jacobs, Hendrickson, J. Comput.
/// Phys. 137 (1997) 346; Lee, Streinu, Discrete Math. 308 (2008) 1425). Each joint has as many
/// pebbles as freedoms; a bar that is independent of those before takes one. In the plane the
/// independent bars are as many as the rank of the rigidity matrix at almost all positions (Laman,
/// J. Engrg. Math. 4 (1970) 331). In space they only have no more than 3 joints - 6 of them among
/// any joints: the rank is never more, but may be less, as in the double banana (Cheng, Sitharam,
/// J. Combin. Theory B 105 (2014) 26). Time: bars times what each search reaches, at worst all.
class JointPebbles {
 public:
  /// `dimension` is 2 or 3.
  JointPebbles(std::size_t joints, std::uint32_t dimension);

  /// Whether a bar is independent of those before it, by this count; if so, it takes a pebble. The
  /// two joints have no bar yet.
  bool add(Joint a, Joint b);

 private:
  static constexpr Joint free = ~Joint{0};
  static constexpr Joint unused = free - 1;  ///< a third pebble in the plane
  /// For each pebble of a joint the other end of the bar that it pays for, or `free`.
  using Pebbles = std::array<Joint, 3>;
  struct Step {
    Joint from = free;
    std::uint32_t pebble = 0;
  };

  bool pays_for_bar_to(Joint joint, Joint other) const;
  bool fetch_pebble(Joint to, Joint a, Joint b);
  bool gather(Joint to, Joint other);
  bool is_in_full_set(Joint a, Joint b);
  void begin_search(Joint from, Joint a, Joint b);
  void carry_back(Joint joint);

  bool in_space_;
  std::vector<Pebbles> pebbles_;                ///< (N)
  std::vector<std::vector<Joint>> neighbours_;  ///< (N) over independent bars
  std::vector<Step> steps_;                     ///< (N) of the current search
  std::vector<std::uint32_t> marks_;            ///< (N) number of the last search that reached it
  std::vector<Joint> reached_;
  std::uint32_t search_ = 0;
};

}  // namespace pliant
