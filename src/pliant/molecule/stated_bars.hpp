// SPDX-License-Identifier: MIT
// What a bars file states beside the bars that a framework has already, such as that of a graph.
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "pliant/framework/framework.hpp"
#include "pliant/molecule/bars_file.hpp"

namespace pliant {

/// Adds each bar in the place of the bar that its joints have, if they have one, else behind all.
/// `measured` gives the rest length (Angstrom) of a bar that states none.
void add_stated(std::span<const StatedBar> stated, const std::function<double(Bar)>& measured,
                FrameworkParts& parts);

/// `framework` with the bars, limits and sterics of the bars file at `path`; of its own bars those
/// that the file asks for: `bars bonds` keeps them, `bars none` (or no such line) does not. Bars
/// without a length get the one at `positions` (N). Throws as read_bars_file, InputError naming the
/// file for `bars angles`, which only molecules have, and for what Framework refuses.
Framework with_stated_bars(const Framework& framework, std::span<const Vec3> positions,
                           const std::filesystem::path& path);

}  // namespace pliant
