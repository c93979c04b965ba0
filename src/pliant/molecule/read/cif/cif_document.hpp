// SPDX-License-Identifier: MIT
// The tables of a CIF file (STAR syntax), as positions in its text. The grammar is gemmi's; only
// cif_document.cpp includes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/text/file_text.hpp"

namespace pliant {

/// A value as written in the text, with its quotes.
struct CifValue {
  std::uint32_t offset = 0, size = 0;
};

/// A category of a data block: a loop, or the single row of its tag-value pairs.
struct CifTable {
  std::string category;           ///< "_atom_site", in lower case
  std::vector<std::string> tags;  ///< without category, in lower case: "cartn_x"
  std::vector<CifValue> values;   ///< row by row
  std::size_t line = 0;           ///< line of its beginning
  bool is_loop = false;

  std::size_t rows() const { return tags.empty() ? 0 : values.size() / tags.size(); }
  std::optional<std::size_t> column(std::string_view tag) const;
  CifValue at(std::size_t row, std::size_t column) const {
    return values[row * tags.size() + column];
  }
};

/// A data block.
struct CifBlock {
  std::string name;
  std::vector<CifTable> tables;
  bool has_fractions = false;  ///< has _atom_site_... tags, as CIF files of small molecules do

  const CifTable* table(std::string_view category) const;
};

/// The requested categories of a file.
struct CifDocument {
  std::string_view text;
  std::vector<CifBlock> blocks;

  std::string_view raw(CifValue value) const { return text.substr(value.offset, value.size); }

  /// The value without quotes and text-field semicolons; "" for "?" and ".".
  std::string_view word(CifValue value) const;
};

/// Finds the lines of values; in a single pass over the text if asked in the order of the text.
class CifLines {
 public:
  explicit CifLines(std::string_view text) : text_(text) {}

  /// Line of a value, from 1.
  std::size_t operator()(CifValue value);

 private:
  std::string_view text_;
  std::size_t offset_ = 0, line_ = 1;
};

}  // namespace pliant
