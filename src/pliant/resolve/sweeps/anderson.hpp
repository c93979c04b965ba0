// SPDX-License-Identifier: MIT
// Anderson acceleration (Anderson mixing; J. ACM 12 (1965) 547) of a sequence x -> g(x), here of
// sweeps. With f = g(x) - x, and the differences dF, dG of the last few f and g as columns,
//
//   gamma = argmin | f - dF gamma |,     x_next = g - dG gamma
//
// (Walker, Ni, SIAM J. Numer. Anal. 49 (2011) 1715). On a linear sequence it is GMRES in disguise;
// on sweeps near whole bars it finds in a few of them what they alone approach geometrically.
// The weights of all g add up to 1, so what every sweep keeps (the centre of mass, pinned joints)
// is kept, and moving or turning everything moves or turns the result.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

class AndersonMixing {
 public:
  static constexpr std::size_t most_columns = 5;  ///< differences remembered

  /// Makes room for sequences of `count` vectors, so that nothing after allocates.
  void reserve(std::size_t count);
  /// Forgets everything before.
  void restart() {
    columns_ = next_column_ = 0;
    has_last_ = false;
  }

  /// Replaces `f` = g(x) - x by the x to go on with. False if there is nothing to go by yet, or
  /// nothing finite: `f` is then left as it was.
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
