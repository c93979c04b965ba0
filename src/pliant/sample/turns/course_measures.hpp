// SPDX-License-Identifier: MIT
// The course of turned joints, and what it does: how far joints go, and which contacts it would
// tear.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/course.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/sample/turns/turn_draws.hpp"

namespace pliant {

/// Joints `from` (N) that turn with their nodes, of_joint (N), while they move by `moves` (N,
/// Angstrom). `nodes` and `of_joint` must outlive it. Not thread-safe.
Course course_of(const NetworkNodes& nodes, std::span<const std::uint32_t> of_joint,
                 const DrawnTurns& turned, std::vector<Vec3> from, std::vector<Vec3> moves);

/// The longest way of a joint from `start` (N), by straight pieces (Angstrom).
double length_of(const Course& course, std::span<const Vec3> start);

/// (L) 1: the limit would be more than 1 Angstrom outside its interval at `x` (N), or another one
/// of its group.
std::vector<std::uint8_t> torn_limits(const Framework& framework, std::span<const Vec3> x);

}  // namespace pliant
