// SPDX-License-Identifier: MIT
// Adds the bars of a bars file to a framework that has bars already, such as that of a graph.
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "pliant/framework/framework.hpp"
#include "pliant/molecule/bars_file.hpp"

namespace pliant {

/// Adds each bar at the end, or replaces the bar of the same joints. `measured` gives the rest
/// length (Angstrom) of a bar that states none.
void add_stated(std::span<const StatedBar> stated, const std::function<double(Bar)>& measured,
                FrameworkParts& parts);

/// `framework` with the bars, limits and sterics of the bars file at `path`. Existing bars are kept
/// if the file says `bars bonds`; with `bars none`, or no such line, they are dropped. Bars without
/// a length get that at `positions` (N). Throws as read_bars_file; InputError naming the file for
/// `bars angles`, which only molecules have, and for what Framework refuses.
Framework with_stated_bars(const Framework& framework, std::span<const Vec3> positions,
                           const std::filesystem::path& path);

}  // namespace pliant
