// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/cif/cif_builder.hpp"

#include <algorithm>

#include "pliant/base/letters.hpp"

namespace pliant {
namespace {

/// What follows the dot of a tag, in lower case.
std::string tail_of(std::string_view tag) {
  const std::size_t dot = tag.find('.');
  return dot == std::string_view::npos ? std::string() : lower_case(tag.substr(dot + 1));
}

}  // namespace

void CifBuilder::begin_block(std::string_view name) {
  document_.blocks.push_back({std::string(name), {}, false});
  tags_.clear();
  in_frame_ = false;
}

void CifBuilder::item_tag(std::string_view tag, std::size_t line) {
  table_ = table_of(add_tag(tag, line), line, false);
  if (table_ != nullptr) table_->tags.push_back(tail_of(tag));
}

void CifBuilder::fail_without_value(std::size_t line) const {
  fail(place(line), "tag " + quoted(last_tag_) + " has no value");
}

void CifBuilder::begin_loop(std::size_t line) {
  table_ = nullptr;
  loop_line_ = line;
  loop_width_ = loop_values_ = 0;
}

void CifBuilder::loop_tag(std::string_view tag, std::size_t line) {
  const std::string category = add_tag(tag, line);
  if (loop_width_++ == 0) table_ = table_of(category, line, true);
  if (table_ == nullptr) return;
  table_->tags.push_back(category == table_->category ? tail_of(tag) : std::string());
}

void CifBuilder::end_loop() const {
  const std::size_t rest = loop_width_ == 0 ? 0 : loop_values_ % loop_width_;
  if (rest == 0) return;
  fail(place(row_line_), "the loop begun on line " + std::to_string(loop_line_) + " has " +
                             std::to_string(loop_width_) + " tags, its last row " +
                             std::to_string(rest) + (rest == 1 ? " value" : " values"));
}

/// Refuses a tag given twice in a block; returns its category: all before the dot.
std::string CifBuilder::add_tag(std::string_view tag, std::size_t line) {
  last_tag_ = tag;
  std::string key = lower_case(tag);
  if (in_frame_) return {};
  if (key.starts_with("_atom_site_") && !document_.blocks.empty())
    document_.blocks.back().has_fractions = true;
  std::string category = key.substr(0, std::min(key.find('.'), key.size()));
  if (!tags_.insert(std::move(key)).second)
    fail(place(line), "tag " + quoted(tag) + " is given twice");
  return category;
}

/// The table of a wanted category in the current block, or null. Pairs of one category share a
/// table; a loop has its own.
CifTable* CifBuilder::table_of(const std::string& category, std::size_t line, bool is_loop) {
  if (in_frame_ || document_.blocks.empty()) return nullptr;
  if (std::find(categories_.begin(), categories_.end(), category) == categories_.end())
    return nullptr;
  auto& tables = document_.blocks.back().tables;
  const auto same = [&](const CifTable& table) { return table.category == category; };
  const auto found = std::find_if(tables.begin(), tables.end(), same);
  if (found == tables.end()) {
    tables.push_back({category, {}, {}, line, is_loop});
    return &tables.back();
  }
  if (is_loop || found->is_loop)
    fail(place(line), "category " + quoted(std::string_view(category)) +
                          " is given twice, the first time on line " + std::to_string(found->line));
  return &*found;
}

}  // namespace pliant
