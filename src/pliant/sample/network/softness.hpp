// SPDX-License-Identifier: MIT
// How soft a molecule is as a whole, by its alpha carbons alone.
#pragma once

#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// 1 / the lowest eigenvalue above zero of Kirchhoff's matrix of nodes (M, Angstrom; the cube of
/// their number). The spring of two nodes within 10 Angstrom is the number of nodes that are
/// neighbours of both. `scale` is that of
/// NetworkNodes. 0 where no two are neighbours.
double softness(std::span<const Vec3> nodes, double scale = 1.0);

}  // namespace pliant
