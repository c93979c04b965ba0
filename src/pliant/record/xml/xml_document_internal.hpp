// SPDX-License-Identifier: MIT
// A parsed XML text whose elements know their lines. Document types are refused before the parser
// sees the text, so that no entity is expanded and no file fetched.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <pugixml.hpp>
#include <string_view>

#include "pliant/base/error.hpp"
#include "pliant/record/xml/xml_text.hpp"

namespace pliant {

using XmlNames = std::initializer_list<std::string_view>;

/// Every function throws InputError naming file, line, element or attribute, what was expected and
/// what was found. The source must outlive it.
class XmlDocument {
 public:
  /// Parses a text with one root element called `root`.
  XmlDocument(const SourceText& source, std::string_view root);

  pugi::xml_node root() const { return document_.document_element(); }
  Place place_of(pugi::xml_node node) const;

  /// Refuses other elements or attributes in `node` than these, and text.
  void expect_elements(pugi::xml_node node, XmlNames names) const;
  void expect_attributes(pugi::xml_node node, XmlNames names) const;

  std::string_view required(pugi::xml_node node, const char* name) const;
  double real(pugi::xml_node node, const char* name) const;
  /// A whole number that is at least `least`.
  std::int64_t integer(pugi::xml_node node, const char* name, std::int64_t least = 0) const;

 private:
  void expect_root(std::string_view name) const;

  const SourceText& source_;
  LineIndex lines_;
  pugi::xml_document document_;
};

/// `text` escaped for an attribute.
std::string xml_escaped(std::string_view text);

}  // namespace pliant
