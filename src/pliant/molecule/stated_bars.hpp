// SPDX-License-Identifier: MIT
// What a bars file states beside the bars that a framework has already, such as that of a graph.
#pragma once

#include <filesystem>
#include <span>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// `framework` with the bars, limits and sterics of the bars file at `path`; of its own bars those
/// that the file asks for: `bars bonds` keeps them, `bars none` (or no such line) does not. Bars
/// without a length get the one at `positions` (N). Throws as read_bars_file, InputError naming the
/// file for `bars angles`, which only molecules have, and for what Framework refuses.
Framework with_stated_bars(const Framework& framework, std::span<const Vec3> positions,
                           const std::filesystem::path& path);

}  // namespace pliant
