// SPDX-License-Identifier: MIT
// The kernels of lane_kernels.hpp, compiled once for each level of instructions. Only internal
// functions and the templates of bar_loops.hpp on types of this level: an inline function of
// another header compiled here could end up in code for every processor.
#include "pliant/resolve/lanes/lane_nearest_kernels.hpp"
#include "pliant/resolve/lanes/lane_newton_kernels.hpp"

#define PLIANT_LANE_TEXT_OF(name) #name
#define PLIANT_LANE_TEXT(name) PLIANT_LANE_TEXT_OF(name)

namespace pliant::PLIANT_LANE_LEVEL {

extern const LaneKernels kernels;
const LaneKernels kernels = {&PLIANT_LANE_TEXT(PLIANT_LANE_LEVEL)[6],  // without "lanes_"
                             gather,
                             scatter,
                             find_whole,
                             confirm_whole,
                             measure,
                             carry,
                             sweep,
                             look,
                             newton,
                             shake,
                             nearest};

}  // namespace pliant::PLIANT_LANE_LEVEL
