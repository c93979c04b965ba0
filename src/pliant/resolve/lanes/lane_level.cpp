// SPDX-License-Identifier: MIT
// The kernels of lane_kernels.hpp, compiled once for each level of instructions. Only internal
// functions and the templates of bar_loops.hpp on types of this level: an inline function of
// another header compiled here could end up in code for every processor.
#include "pliant/resolve/lanes/lane_bar_newton_kernels.hpp"
#include "pliant/resolve/lanes/lane_body_kernels.hpp"
#include "pliant/resolve/lanes/lane_distance_kernels.hpp"
#include "pliant/resolve/lanes/lane_nearest_kernels.hpp"

#define PLIANT_LANE_TEXT_OF(name) #name
#define PLIANT_LANE_TEXT(name) PLIANT_LANE_TEXT_OF(name)

namespace pliant::PLIANT_LANE_LEVEL {

constexpr char prefix[] = "lanes_";
constexpr const char* level_name =
    &PLIANT_LANE_TEXT(PLIANT_LANE_LEVEL)[sizeof prefix - 1];  // "v3" of lanes_v3

extern const LaneKernels kernels;
const LaneKernels kernels = {.level = level_name,
                             .gather = gather,
                             .scatter = scatter,
                             .find_whole = find_whole,
                             .confirm_whole = confirm_whole,
                             .measure = measure,
                             .carry = carry,
                             .sweep = sweep,
                             .look = look,
                             .block_newton = block_newton,
                             .shake = shake,
                             .nearest = nearest,
                             .approach = approach,
                             .bodies = &body_kernels};

}  // namespace pliant::PLIANT_LANE_LEVEL
