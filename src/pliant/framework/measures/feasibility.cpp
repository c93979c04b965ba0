// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/feasibility.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace pliant {
namespace {

constexpr auto unmarked = std::numeric_limits<BarIndex>::max();
/// A taut triangle made from rounded coordinates misses its inequality by this much.
constexpr double rounding = 1e-9;

/// Lists triangles by going from each joint to joints of more bars only (Chiba, Nishizeki, SIAM J.
/// Comput. 14 (1985) 210): each triangle once, and stars cost nothing.
class TriangleSearch {
 public:
  TriangleSearch(const Framework& framework, std::size_t most)
      : framework_(framework), most_(most), bar_to_(framework.joint_count(), unmarked) {}

  std::vector<std::string> run() {
    for (std::size_t i = 0; i < framework_.joint_count() && found_.size() < most_; ++i)
      look_from(static_cast<Joint>(i));
    return std::move(found_);
  }

 private:
  bool goes_up(Joint from, Joint to) const {
    const auto a = framework_.neighbours(from).size(), b = framework_.neighbours(to).size();
    return a != b ? a < b : from < to;
  }

  void look_from(Joint a) {
    for (const Incidence& at : framework_.neighbours(a))
      if (goes_up(a, at.joint)) bar_to_[at.joint] = at.bar;
    for (const Incidence& ab : framework_.neighbours(a)) {
      if (!goes_up(a, ab.joint)) continue;
      for (const Incidence& bc : framework_.neighbours(ab.joint))
        if (goes_up(ab.joint, bc.joint) && bar_to_[bc.joint] != unmarked)
          check_triangle(ab.bar, bc.bar, bar_to_[bc.joint]);
    }
    for (const Incidence& at : framework_.neighbours(a)) bar_to_[at.joint] = unmarked;
  }

  void check_triangle(BarIndex p, BarIndex q, BarIndex r) {
    BarIndex bars[] = {p, q, r};
    const auto rests = framework_.rest_lengths();
    std::sort(std::begin(bars), std::end(bars),
              [&](BarIndex x, BarIndex y) { return rests[x] < rests[y]; });
    const double reach = rests[bars[0]] + rests[bars[1]];
    if (rests[bars[2]] <= reach * (1.0 + rounding) || found_.size() >= most_) return;
    char lengths[96];
    std::snprintf(lengths, sizeof lengths, "%.6g is longer than %.6g and %.6g together",
                  rests[bars[2]], rests[bars[0]], rests[bars[1]]);
    const auto label = [&](BarIndex bar) { return framework_.label(framework_.bars()[bar]); };
    found_.push_back("bars " + label(bars[0]) + ", " + label(bars[1]) + " and " + label(bars[2]) +
                     " cannot hold together: " + lengths);
  }

  const Framework& framework_;
  std::size_t most_;
  std::vector<BarIndex> bar_to_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> impossible_triangles(const Framework& framework, std::size_t most) {
  return TriangleSearch(framework, most).run();
}

}  // namespace pliant
