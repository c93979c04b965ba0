// SPDX-License-Identifier: MIT
// The displacements of all joints along one mode of an elastic network.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

/// (N) displacements (Angstrom) of joints at `start` (N) along mode `mode` (1 has the largest
/// variance), scaled so that the r.m.s. displacement of the nodes is `amplitude` (Angstrom). Joints
/// move and rotate with their nodes as in frames of a sample (ModeDisplacement); the sign is that
/// of the mode. Throws OptionError if there is no such mode, or as check() of the nodes does.
std::vector<Vec3> mode_field(const NetworkNodes& nodes, std::span<const Vec3> start,
                             std::size_t mode, double amplitude,
                             std::string_view network = "shared");

}  // namespace pliant
