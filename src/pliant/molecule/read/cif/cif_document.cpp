// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/cif/cif_document.hpp"

#include <algorithm>

namespace pliant {

std::optional<std::size_t> CifTable::column(std::string_view tag) const {
  const auto found = std::find(tags.begin(), tags.end(), tag);
  if (found == tags.end()) return std::nullopt;
  return static_cast<std::size_t>(found - tags.begin());
}

const CifTable* CifBlock::table(std::string_view category) const {
  for (const CifTable& table : tables)
    if (table.category == category) return &table;
  return nullptr;
}

std::string_view CifDocument::word(CifValue value) const {
  std::string_view word = raw(value);
  if (word == "?" || word == ".") return {};
  if (word.size() >= 2 && (word[0] == '"' || word[0] == '\''))
    return word.substr(1, word.size() - 2);
  if (word.size() >= 2 && word[0] == ';' && word.back() == ';') {
    word = word.substr(1, word.size() - 2);
    while (!word.empty() && (word.back() == '\n' || word.back() == '\r')) word.remove_suffix(1);
  }
  return word;
}

std::size_t CifLines::operator()(CifValue value) {
  if (value.offset < offset_) {
    offset_ = 0;
    line_ = 1;
  }
  const std::string_view passed = text_.substr(offset_, value.offset - offset_);
  line_ += static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
  offset_ = value.offset;
  return line_;
}

}  // namespace pliant
