// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {
namespace {

template <class Thing>
void grow(std::vector<Thing>& room, std::size_t count) {
  if (room.size() < count) room.resize(count);
}

}  // namespace

std::vector<LaneBar> lane_bars(const Framework& framework, const Tolerance& tolerance) {
  std::vector<LaneBar> bars;
  bars.reserve(framework.bar_count());
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    const Bar bar = framework.bars()[k];
    const double rest = framework.rest_lengths()[k];
    bars.push_back(lane_bar(bar.a, bar.b, rest, tolerance.of(rest)));
  }
  return bars;
}

void LaneScratch::fit(const BarPattern& part) {
  const std::size_t joints = part.joints.size(), bars = part.bars.size();
  const std::size_t entries =
      part.ldl.column_begin[part.bars.end] - part.ldl.column_begin[part.bars.begin];
  grow(x_, joints);
  grow(best_, joints);
  grow(directions_, bars);
  grow(along_, bars);
  grow(excess_, bars);
  grow(diagonal_, bars);
  grow(inverse_, bars);
  grow(lower_, entries);
}

LaneRoom LaneScratch::room() {
  return {x_.data(),      best_.data(),     directions_.data(), along_.data(),
          excess_.data(), diagonal_.data(), inverse_.data(),    lower_.data()};
}

}  // namespace pliant
