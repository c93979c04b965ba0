// SPDX-License-Identifier: MIT
// Projection of one bar: the kernel of every sweep.
//
//   delta = x_far - x_near,  d = |delta|,  n = delta / d,  C = d - L
//   x_near += s_near C n,    x_far -= s_far C n,           s_near + s_far = 1
//
// so that the bar has its rest length L afterwards (Jakobsen, "Advanced character physics", GDC
// 2001; thesis figure 2.4). If both joints coincide there is no n, and `escape` gives one.
#pragma once

#include <cmath>

#include "pliant/base/random.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// The direction in which coincident joints of a bar separate: random, from its key.
inline Vec3 escape_direction(RandomKey key, BarIndex bar, bool planar) {
  key.domain = Domain::escape;
  key.joint = bar;
  RandomSequence draws(key);
  return planar ? draws.direction_in_plane() : draws.direction();
}

/// Moves two joints so that their distance is `rest` (Angstrom). `escape()` gives a unit vector and
/// is called only if the joints coincide. Shares of two pinned joints are both 0: nothing moves.
template <class Escape>
inline void project_bar(Vec3& near, Vec3& far, double rest, double near_share, double far_share,
                        Escape&& escape) {
  const Vec3 delta = far - near;
  const double squared = norm_squared(delta);
  if (squared < least_squared_length) [[unlikely]] {
    const Vec3 apart = rest * escape();
    near -= near_share * apart;
    far += far_share * apart;
    return;
  }
  const double d = std::sqrt(squared);
  const Vec3 excess = ((d - rest) / d) * delta;
  near += near_share * excess;
  far -= far_share * excess;
}

/// The same where the far joint takes all: `near` does not move.
template <class Escape>
inline void carry_far(Vec3 near, Vec3& far, double rest, Escape&& escape) {
  const Vec3 delta = far - near;
  const double squared = norm_squared(delta);
  if (squared < least_squared_length) [[unlikely]] {
    far += rest * escape();
    return;
  }
  const double d = std::sqrt(squared);
  far -= ((d - rest) / d) * delta;
}

}  // namespace pliant
