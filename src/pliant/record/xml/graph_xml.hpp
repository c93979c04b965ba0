// SPDX-License-Identifier: MIT
// Graph XML: a framework with its positions in a text file, the format of the thesis' StructGen.
//
//   <graph dimension="3">
//     <joint id="a" x="0" y="0" z="0" mass="12" pinned="true"/>
//     <joint id="b" x="1" y="0" z="0"/>
//     <bar a="a" b="b" length="1"/>
//     <cycle joints="a b c"/>
//   </graph>
//
// Positions and lengths are in Angstrom, masses in u. Without mass, pinned or length, a mass of 1,
// a joint that is not pinned, and the distance of the joints are assumed; cycles are optional.
// dimension="2" makes a planar framework: joints without z have z = 0, and no push changes the z of
// a joint.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

/// Contents of a graph XML file. The ids of joints are the names of the framework's atoms.
struct GraphFile {
  Framework framework;
  std::vector<Vec3> positions;             ///< (N) Angstrom
  std::vector<std::vector<Joint>> cycles;  ///< each as the joints along it
};

/// Whether a text looks like XML.
bool looks_like_xml(std::string_view text);

/// Throws InputError naming file, line and attribute; FileError if the file cannot be read. Warns
/// of bars that cannot all have their rest lengths, and of bars given twice.
GraphFile read_graph_xml(const std::filesystem::path& path, const Log& log = {});
GraphFile parse_graph_xml(const SourceText& source, const Log& log = {});

}  // namespace pliant
