// SPDX-License-Identifier: MIT
// Checks of XML before it is parsed: UTF-8, no document type, not nested deeply.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "pliant/text/file_text.hpp"

namespace pliant {

/// Deepest nesting of elements. A graph needs two levels; parsers that recurse need a limit.
inline constexpr std::size_t deepest_xml = 64;

/// Throws InputError for empty or binary text, UTF-16, bytes that are not UTF-8 (naming the
/// offset), a document type, entities other than XML's own five, and elements deeper than
/// deepest_xml.
void check_xml_text(const SourceText& source);

/// Finds the lines of offsets in a text, from 1.
class LineIndex {
 public:
  explicit LineIndex(std::string_view text);
  std::size_t line_of(std::size_t offset) const;
  std::size_t column_of(std::size_t offset) const;  ///< in bytes, from 1

 private:
  std::vector<std::size_t> starts_;
};

}  // namespace pliant
