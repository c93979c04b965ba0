// SPDX-License-Identifier: MIT
// Superposition (least-squares fit) of whole sets of points, and how far they fluctuate when what
// they do together, shifts and turns, is taken out.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// The rigid motion that brings `points` (n) nearest to `goal` (n), by least squares. It never
/// reflects. Fewer than three points are shifted only: a turn about them would be arbitrary.
RigidMotion superposition(std::span<const Vec3> points, std::span<const Vec3> goal);

/// (n) r.m.s. fluctuation of each point over frames superposed on their mean, which is found by
/// repeating. frames: (F) of n points each; none gives nothing.
std::vector<double> superposed_fluctuations(std::vector<std::vector<Vec3>> frames);

}  // namespace pliant
