// SPDX-License-Identifier: MIT
// What a course does: how far joints go, and which contacts it would tear.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/course.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// The longest way of a joint from `start` (N), by straight pieces (Angstrom).
double length_of(const Course& course, std::span<const Vec3> start);

/// (L) 1: the limit would be more than 1 Angstrom outside its interval at `x` (N), or another one
/// of its group.
std::vector<std::uint8_t> torn_limits(const Framework& framework, std::span<const Vec3> x);

}  // namespace pliant
