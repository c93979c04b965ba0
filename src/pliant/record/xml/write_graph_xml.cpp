// SPDX-License-Identifier: MIT
#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "pliant/record/xml/xml_document_internal.hpp"

namespace pliant {
namespace {

/// Ids of joints: their names where no two are alike, else "0", "1", ...
std::vector<std::string> ids_of(const Framework& framework) {
  std::vector<std::string> ids;
  if (framework.atoms()) {
    ids = framework.atoms()->names;
    std::vector<std::string> sorted = ids;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end()) return ids;
    ids.clear();
  }
  for (std::size_t i = 0; i < framework.joint_count(); ++i) ids.push_back(std::to_string(i));
  return ids;
}

std::string joint_element(const Framework& framework, Joint joint, Vec3 at, std::string_view id) {
  std::string text = "  <joint id=\"" + xml_escaped(id) + "\" x=\"" + shortest_text(at.x) +
                     "\" y=\"" + shortest_text(at.y) + "\"";
  if (!framework.is_planar() || at.z != 0.0) text += " z=\"" + shortest_text(at.z) + "\"";
  const double inverse_mass = framework.inverse_masses()[joint];
  if (inverse_mass == 0.0) {
    text += " pinned=\"true\"";
  } else if (inverse_mass != 1.0) {
    text += " mass=\"" + shortest_text(1.0 / inverse_mass) + "\"";
  }
  return text + "/>\n";
}

}  // namespace

std::string write_graph_xml(const Framework& framework, std::span<const Vec3> positions,
                            std::span<const std::vector<Joint>> cycles) {
  if (positions.size() != framework.joint_count())
    throw InputError("graph: " + std::to_string(framework.joint_count()) + " joints but " +
                     std::to_string(positions.size()) + " positions");
  const std::vector<std::string> ids = ids_of(framework);
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<graph dimension=\"";
  text += framework.is_planar() ? "2\">\n" : "3\">\n";
  for (std::size_t i = 0; i < positions.size(); ++i)
    text += joint_element(framework, static_cast<Joint>(i), positions[i], ids[i]);
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    const Bar bar = framework.bars()[k];
    text += "  <bar a=\"" + xml_escaped(ids[bar.a]) + "\" b=\"" + xml_escaped(ids[bar.b]) +
            "\" length=\"" + shortest_text(framework.rest_lengths()[k]) + "\"/>\n";
  }
  for (const std::vector<Joint>& cycle : cycles) {
    text += "  <cycle joints=\"";
    for (std::size_t k = 0; k < cycle.size(); ++k)
      text += (k == 0 ? "" : " ") + xml_escaped(ids[cycle[k]]);
    text += "\"/>\n";
  }
  return text + "</graph>\n";
}

}  // namespace pliant
