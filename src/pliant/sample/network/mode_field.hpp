// SPDX-License-Identifier: MIT
// The displacement of all joints along one mode of an elastic network.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/sample/network/elastic_network.hpp"

namespace pliant {

/// (N) Angstrom, of joints at `start` (N): mode `mode`, from 1 for the one of largest variance, so
/// that the r.m.s. displacement of the nodes is `amplitude` (Angstrom). Joints go and turn with
/// their nodes, as frames of a sample do (ModeDisplacement); the sign is that of the mode. Throws
/// OptionError where there is no such mode, or as check() of the nodes does.
std::vector<Vec3> mode_field(const NetworkNodes& nodes, std::span<const Vec3> start,
                             std::size_t mode, double amplitude,
                             std::string_view network = "shared");

}  // namespace pliant
