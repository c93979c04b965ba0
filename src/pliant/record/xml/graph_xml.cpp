// SPDX-License-Identifier: MIT
#include "pliant/record/xml/graph_xml.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/measures/feasibility.hpp"
#include "pliant/record/xml/xml_document_internal.hpp"

namespace pliant {
namespace {

/// Reads the elements of a graph, keeping the place for messages.
class GraphParser {
 public:
  GraphParser(const SourceText& source, const Log& log)
      : source_(source), log_(log), xml_(source, "graph"), atoms_(std::make_shared<AtomTable>()) {
    atoms_->residues.push_back({"", 1, ' ', ""});
  }

  GraphFile parse() {
    read_root();
    for (pugi::xml_node node : root_.children("joint")) read_joint(node);
    for (pugi::xml_node node : root_.children("bar")) read_bar(node);
    for (pugi::xml_node node : root_.children("cycle")) read_cycle(node);
    if (positions_.empty()) fail({source_.name}, "holds no joint");
    return finish();
  }

 private:
  Place place_of(pugi::xml_node node) const { return xml_.place_of(node); }
  std::string_view required(pugi::xml_node node, const char* name) const {
    return xml_.required(node, name);
  }
  double number(pugi::xml_node node, const char* name) const { return xml_.real(node, name); }

  void read_root() {
    xml_.expect_elements(root_, {"joint", "bar", "cycle"});
    xml_.expect_attributes(root_, {"dimension"});
    const auto dimension = root_.attribute("dimension");
    if (!dimension) return;
    planar_ = std::string_view(dimension.value()) == "2";
    if (!planar_ && std::string_view(dimension.value()) != "3")
      fail(place_of(root_), "dimension: expected 2 or 3, found " + quoted(dimension.value()));
  }

  void read_joint(pugi::xml_node node) {
    xml_.expect_elements(node, {});
    xml_.expect_attributes(node, {"id", "x", "y", "z", "mass", "pinned"});
    const std::string_view id = required(node, "id");
    check_id(node, id);
    const auto joint = static_cast<Joint>(positions_.size());
    const auto [at, is_new] = joints_.emplace(std::string(id), joint);
    if (!is_new)
      fail(place_of(node), "joint " + quoted(id) + " is given twice, first in line " +
                               std::to_string(joint_lines_[at->second]));
    joint_lines_.push_back(place_of(node).line);
    const bool flat = planar_ && !node.attribute("z");
    positions_.push_back({number(node, "x"), number(node, "y"), flat ? 0.0 : number(node, "z")});
    masses_.push_back(node.attribute("mass") ? number(node, "mass") : 1.0);
    if (is_pinned(node)) pinned_.push_back(joint);
    atoms_->names.emplace_back(id);
    atoms_->elements.push_back(0);
    atoms_->residue_of.push_back(0);
    atoms_->serials.push_back(static_cast<std::int64_t>(positions_.size()));
  }

  void check_id(pugi::xml_node node, std::string_view id) const {
    if (id.empty()) fail(place_of(node), "id: expected a name, found \"\"");
    for (char c : id)
      if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f)
        fail(place_of(node),
             "id: blanks and control characters are not allowed, found " + quoted(id));
  }

  bool is_pinned(pugi::xml_node node) const {
    const auto attribute = node.attribute("pinned");
    const std::string_view text = attribute ? attribute.value() : "false";
    if (text != "true" && text != "false")
      fail(place_of(node), "pinned: expected true or false, found " + quoted(text));
    return text == "true";
  }

  Joint joint_of(pugi::xml_node node, std::string_view id) const {
    const auto at = joints_.find(std::string(id));
    if (at == joints_.end())
      fail(place_of(node), std::string(node.name()) + ": no joint has the id " + quoted(id));
    return at->second;
  }

  void read_bar(pugi::xml_node node) {
    xml_.expect_elements(node, {});
    xml_.expect_attributes(node, {"a", "b", "length"});
    const Bar bar{joint_of(node, required(node, "a")), joint_of(node, required(node, "b"))};
    const std::string name = quoted(required(node, "a")) + " - " + quoted(required(node, "b"));
    if (bar.a == bar.b) fail(place_of(node), "bar " + name + " joins a joint to itself");
    const bool stated = static_cast<bool>(node.attribute("length"));
    const double length =
        stated ? number(node, "length") : distance(positions_[bar.a], positions_[bar.b]);
    if (!(length > 0.0))
      fail(place_of(node),
           "bar " + name + ": length: expected a number above 0, found " +
               (stated ? quoted(required(node, "length")) : std::string("joints at one point")));
    if (is_repeated(node, bar, length, name)) return;
    bars_.push_back(bar);
    lengths_.push_back(length);
  }

  struct Given {
    std::size_t line;
    double length;
  };

  bool is_repeated(pugi::xml_node node, Bar bar, double length, const std::string& name) {
    const auto pair = std::minmax(bar.a, bar.b);
    const auto [at, is_new] = given_.emplace(pair, Given{place_of(node).line, length});
    if (is_new) return false;
    const std::string first = " is given twice, first in line " + std::to_string(at->second.line);
    if (at->second.length != length)
      fail(place_of(node), "bar " + name + first + ": with the lengths " +
                               shortest_text(at->second.length) + " and " + shortest_text(length));
    log_.warn(pliant::at(place_of(node), "bar " + name + first + ": merged"));
    return true;
  }

  void read_cycle(pugi::xml_node node) {
    xml_.expect_elements(node, {});
    xml_.expect_attributes(node, {"joints"});
    std::vector<Joint> cycle;
    std::string_view rest = required(node, "joints");
    while (!(rest = trimmed(rest)).empty()) {
      const std::size_t end = std::min(rest.find_first_of(" \t\n\r"), rest.size());
      cycle.push_back(joint_of(node, rest.substr(0, end)));
      rest.remove_prefix(end);
    }
    for (std::size_t k = 0; k < cycle.size(); ++k) {
      const Joint from = cycle[k], to = cycle[(k + 1) % cycle.size()];
      if (cycle.size() < 3 || !given_.contains(std::minmax(from, to)))
        fail(place_of(node), "cycle: no bar joins " + pliant::quoted(atoms_->names[from]) +
                                 " and " + pliant::quoted(atoms_->names[to]));
    }
    cycles_.push_back(std::move(cycle));
  }

  GraphFile finish() {
    FrameworkParts parts;
    parts.joint_count = positions_.size();
    parts.bars = std::move(bars_);
    parts.rest_lengths = std::move(lengths_);
    parts.masses = std::move(masses_);
    parts.pinned = std::move(pinned_);
    parts.atoms = atoms_;
    parts.planar = planar_;
    try {
      GraphFile graph{Framework(std::move(parts)), std::move(positions_), std::move(cycles_)};
      for (const std::string& text : impossible_triangles(graph.framework))
        log_.warn(pliant::at({source_.name}, text));
      return graph;
    } catch (const InputError& error) {
      fail({source_.name}, error.what());
    }
  }

  const SourceText& source_;
  const Log& log_;
  XmlDocument xml_;
  pugi::xml_node root_ = xml_.root();
  bool planar_ = false;
  std::shared_ptr<AtomTable> atoms_;
  std::unordered_map<std::string, Joint> joints_;
  std::vector<std::size_t> joint_lines_;
  std::vector<Vec3> positions_;
  std::vector<double> masses_;
  std::vector<Joint> pinned_;
  std::vector<Bar> bars_;
  std::vector<double> lengths_;
  std::map<std::pair<Joint, Joint>, Given> given_;
  std::vector<std::vector<Joint>> cycles_;
};

}  // namespace

bool looks_like_xml(std::string_view text) {
  text = without_byte_order_mark(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

GraphFile parse_graph_xml(const SourceText& source, const Log& log) {
  return GraphParser(source, log).parse();
}

GraphFile read_graph_xml(const std::filesystem::path& path, const Log& log) {
  const std::string bytes = read_bytes(path);
  const std::string name = path_text(path);
  return parse_graph_xml({name, without_byte_order_mark(bytes)}, log);
}

}  // namespace pliant
