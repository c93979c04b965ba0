// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_kernels.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

namespace lanes_portable {
extern const LaneKernels kernels;
}
#ifdef PLIANT_LANES_X86
namespace lanes_v2 {
extern const LaneKernels kernels;
}
namespace lanes_v3 {
extern const LaneKernels kernels;
}
namespace lanes_v4 {
extern const LaneKernels kernels;
}
#endif

namespace {

#ifdef PLIANT_LANES_X86
// Asks for no more than the compiler was allowed for the level: see CMakeLists.txt.
bool has_v2() { return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt"); }
bool has_v3() {
  return has_v2() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2");
}
bool has_v4() {
  return has_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}
#endif

std::vector<const LaneKernels*> usable_levels() {
  std::vector<const LaneKernels*> levels;
#ifdef PLIANT_LANES_X86
  if (has_v4()) levels.push_back(&lanes_v4::kernels);
  if (has_v3()) levels.push_back(&lanes_v3::kernels);
  if (has_v2()) levels.push_back(&lanes_v2::kernels);
#endif
  levels.push_back(&lanes_portable::kernels);
  return levels;
}

}  // namespace

/// With t = length^2 / rest^2 - 1 the residual is at most (|t| + t^2) / 2 of the rest length; 2^-46
/// is a hundred roundings.
LaneBar lane_bar(std::uint32_t a, std::uint32_t b, double rest, double allowed) {
  const double relative = allowed / rest, squared = rest * rest;
  double surely = (2.0 * relative * (1.0 - 4.0 * relative) - 0x1p-46) * squared;
  if (squared < least_squared_length || !(surely > 0.0)) surely = 0.0;
  // However much is allowed, an infinite length is not whole.
  const double finite = std::min(allowed, std::numeric_limits<double>::max());
  return {a, b, rest, finite, squared, surely};
}

std::span<const LaneKernels* const> lane_levels() {
  static const std::vector<const LaneKernels*> levels = usable_levels();
  return levels;
}

}  // namespace pliant
