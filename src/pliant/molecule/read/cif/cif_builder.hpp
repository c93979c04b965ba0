// SPDX-License-Identifier: MIT
// Builds a CifDocument from what the grammar finds, tag by tag and value by value, and refuses what
// the grammar lets pass.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/molecule/read/cif/cif_document.hpp"

namespace pliant {

/// Fills a document while the grammar is matched. Throws InputError for tags and categories given
/// twice, tags without values, and loops whose last row is not full.
class CifBuilder {
 public:
  CifBuilder(const SourceText& source, const std::vector<std::string_view>& categories,
             CifDocument& document)
      : source_(source), categories_(categories), document_(document) {}

  void begin_block(std::string_view name);
  void begin_frame() { in_frame_ = true; }
  void end_frame() { in_frame_ = false; }

  void item_tag(std::string_view tag, std::size_t line);
  void item_value(CifValue value) {
    if (table_ != nullptr) table_->values.push_back(value);
  }
  [[noreturn]] void fail_without_value(std::size_t line) const;

  void begin_loop(std::size_t line);
  void loop_tag(std::string_view tag, std::size_t line);
  void loop_value(CifValue value, std::size_t line) {
    if (loop_values_++ % loop_width_ == 0) row_line_ = line;
    if (table_ != nullptr) table_->values.push_back(value);
  }
  void end_loop() const;

  /// Called at both ends of a text field: if a field is not closed, the last call marked its
  /// beginning.
  void text_field_mark(std::size_t line) { text_field_line_ = line; }

  std::size_t loop_line() const { return loop_line_; }
  std::size_t text_field_line() const { return text_field_line_; }

 private:
  Place place(std::size_t line) const { return {source_.name, line}; }
  std::string add_tag(std::string_view tag, std::size_t line);
  CifTable* table_of(const std::string& category, std::size_t line, bool is_loop);

  const SourceText& source_;
  const std::vector<std::string_view>& categories_;
  CifDocument& document_;
  std::unordered_set<std::string> tags_;  // of the block, in lower case
  std::string_view last_tag_;
  CifTable* table_ = nullptr;  // table of the current tag or loop; null if nobody asked for it
  bool in_frame_ = false;
  std::size_t loop_line_ = 0, loop_width_ = 0, loop_values_ = 0, row_line_ = 0;
  std::size_t text_field_line_ = 0;
};

}  // namespace pliant
