// SPDX-License-Identifier: MIT
// Superposition (least-squares fit) of whole sets of points, and how far they fluctuate once their
// common shifts and turns are removed.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// The rigid motion that brings `points` (n) nearest to `goal` (n), by least squares. It never
/// reflects. Fewer than three points are shifted only: a turn about them would be arbitrary.
RigidMotion superposition(std::span<const Vec3> points, std::span<const Vec3> goal);

/// (n) r.m.s. fluctuation of each point over `frames` (F x n points), superposed on their mean,
/// which is found by iteration. Empty if there are no frames.
std::vector<double> superposed_fluctuations(std::vector<std::vector<Vec3>> frames);

}  // namespace pliant
