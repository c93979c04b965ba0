// SPDX-License-Identifier: MIT
// Writing graph XML: what graph_xml.hpp reads.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Returns text that parse_graph_xml reads back to the same bits. Throws InputError if the number
/// of positions is not that of the joints.
std::string write_graph_xml(const Framework& framework, std::span<const Vec3> positions,
                            std::span<const std::vector<Joint>> cycles = {});

}  // namespace pliant
