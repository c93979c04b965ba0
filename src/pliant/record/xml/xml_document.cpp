// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>

#include "pliant/base/number.hpp"
#include "pliant/record/xml/xml_document_internal.hpp"

namespace pliant {
namespace {

/// "joint, bar or cycle".
std::string listed(XmlNames names) {
  std::string text;
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (name != names.begin()) text += name + 1 == names.end() ? " or " : ", ";
    text += *name;
  }
  return text.empty() ? "none" : text;
}

std::string_view without_blanks(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

bool is_among(std::string_view word, XmlNames names) {
  return std::find(names.begin(), names.end(), word) != names.end();
}

std::size_t offset_from(std::ptrdiff_t offset) {
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset));
}

}  // namespace

XmlDocument::XmlDocument(const SourceText& source, std::string_view root)
    : source_(source), lines_(source.text) {
  check_xml_text(source);
  const auto result = document_.load_buffer(source.text.data(), source.text.size(),
                                            pugi::parse_default, pugi::encoding_utf8);
  const std::size_t offset = offset_from(result.offset);
  if (!result)
    fail({source.name, lines_.line_of(offset)},
         "column " + std::to_string(lines_.column_of(offset)) +
             ": is not well-formed XML: " + result.description());
  expect_root(root);
}

void XmlDocument::expect_root(std::string_view name) const {
  if (root().name() != name)
    fail(place_of(root()),
         "expected the root element " + std::string(name) + ", found " + quoted(root().name()));
  for (pugi::xml_node node = root().next_sibling(); node; node = node.next_sibling())
    if (node.type() == pugi::node_element)
      fail(place_of(node), "expected one root element, found a second: " + quoted(node.name()));
}

Place XmlDocument::place_of(pugi::xml_node node) const {
  return {source_.name, lines_.line_of(offset_from(node.offset_debug()))};
}

void XmlDocument::expect_elements(pugi::xml_node node, XmlNames names) const {
  for (pugi::xml_node child : node.children()) {
    const bool is_text = child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata;
    if (!is_text && child.type() != pugi::node_element) continue;
    if (is_text || !is_among(child.name(), names))
      fail(place_of(child), "expected " + listed(names) + ", found " +
                                quoted(is_text ? without_blanks(child.value()) : child.name()));
  }
}

void XmlDocument::expect_attributes(pugi::xml_node node, XmlNames names) const {
  for (auto attribute = node.attributes_begin(); attribute != node.attributes_end(); ++attribute) {
    if (!is_among(attribute->name(), names))
      fail(place_of(node), std::string(node.name()) + ": expected the attributes " + listed(names) +
                               ", found " + quoted(attribute->name()));
    for (auto earlier = node.attributes_begin(); earlier != attribute; ++earlier)
      if (std::string_view(earlier->name()) == attribute->name())
        fail(place_of(node),
             std::string(node.name()) + ": the attribute " + attribute->name() + " is given twice");
  }
}

std::string_view XmlDocument::required(pugi::xml_node node, const char* name) const {
  const auto attribute = node.attribute(name);
  if (!attribute) fail(place_of(node), std::string(node.name()) + " without attribute " + name);
  return attribute.value();
}

double XmlDocument::real(pugi::xml_node node, const char* name) const {
  const std::string_view text = required(node, name);
  const auto value = parse_real(text);
  if (!value)
    fail(place_of(node), std::string(name) + ": expected a finite number, found " + quoted(text));
  return *value;
}

std::int64_t XmlDocument::integer(pugi::xml_node node, const char* name, std::int64_t least) const {
  const std::string_view text = required(node, name);
  const auto value = parse_integer(text);
  if (!value || *value < least)
    fail(place_of(node), std::string(name) + ": expected a whole number from " +
                             std::to_string(least) + ", found " + quoted(text));
  return *value;
}

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace pliant
