// SPDX-License-Identifier: MIT
// Tables in JSON (RFC 8259): a list of flat objects, with the line of each for error messages.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/text/file_text.hpp"

namespace pliant {

/// One object of the list.
struct JsonRow {
  std::size_t line = 0;  ///< where it begins, from 1
  /// By name: a text as it is meant, in UTF-8; a number as it is written; null as "".
  std::map<std::string, std::string, std::less<>> cells;
};

/// Whether a text begins as JSON does, with { or [.
bool looks_like_json(std::string_view text);

/// The rows of {"`list`": [{...}, ...]}. Throws InputError naming file and line where the text is
/// no JSON, has another form, names a cell twice, or has a cell that is no text, number or null.
std::vector<JsonRow> parse_json_rows(const SourceText& source, std::string_view list);

}  // namespace pliant
