// SPDX-License-Identifier: MIT
// Anderson acceleration (Anderson mixing; J. ACM 12 (1965) 547) of a sequence x -> g(x), here of
// sweeps. With f = g(x) - x, and the differences dF, dG of the last few f and g as columns,
//
//   gamma = argmin | f - dF gamma |,     x_next = g - dG gamma
//
// (Walker, Ni, SIAM J. Numer. Anal. 49 (2011) 1715). On a linear sequence it is equivalent to
// GMRES; near whole bars, where sweeps converge geometrically, it needs only a few of them. The
// weights of all g add up to 1, so that what every sweep preserves (the centre of mass, pinned
// joints) is preserved, and moving or rotating everything moves or rotates the result.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

class AndersonMixing {
 public:
  static constexpr std::size_t most_columns = 5;  ///< number of differences kept

  /// Makes room for sequences of `count` vectors, so that later calls allocate nothing.
  void reserve(std::size_t count);
  /// Forgets everything before.
  void restart() {
    columns_ = next_column_ = 0;
    has_last_ = false;
  }

  /// Replaces `f` = g(x) - x by the next x. Returns false, without changing `f`, if there are no
  /// differences yet, or if they are not finite.
  bool mix(std::span<Vec3> f, std::span<const Vec3> g);

 private:
  using Column = std::array<double, most_columns>;

  void remember(std::span<const Vec3> f, std::span<const Vec3> g);
  void add_column(std::span<const Vec3> f, std::span<const Vec3> g);
  bool solve(std::span<const Vec3> f, Column& gamma) const;

  std::size_t columns_ = 0, next_column_ = 0;
  bool has_last_ = false;
  std::vector<Vec3> last_f_, last_g_;
  std::array<std::vector<Vec3>, most_columns> df_, dg_;
  std::array<Column, most_columns> gram_{};  ///< scalar products of the columns of dF
};

}  // namespace pliant
