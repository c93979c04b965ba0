// SPDX-License-Identifier: MIT
#include "pliant/record/xml/xml_text.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

/// Bytes of the UTF-8 character at the start of `text`; 0 if there is none.
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xc0) != 0x80) return 0;
  // overlong forms, surrogates and what lies beyond U+10FFFF
  if (first == 0xe0 && byte(1) < 0xa0) return 0;
  if (first == 0xed && byte(1) > 0x9f) return 0;
  if (first == 0xf0 && byte(1) < 0x90) return 0;
  if (first == 0xf4 && byte(1) > 0x8f) return 0;
  return length;
}

void check_utf8(const SourceText& source) {
  for (std::size_t i = 0; i < source.text.size();) {
    const std::size_t length = utf8_length(source.text.substr(i));
    if (length == 0) fail({source.name}, "byte " + std::to_string(i) + " is not UTF-8 text");
    i += length;
  }
}

std::size_t line_at(std::string_view text, std::size_t offset) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + std::ptrdiff_t(offset), '\n'));
}

/// Where the markup that begins at `at` ends. Attribute values may hold '>'.
std::size_t end_of_markup(std::string_view text, std::size_t at) {
  const auto after = [&](std::string_view mark) {
    const std::size_t found = text.find(mark, at);
    return found == std::string_view::npos ? text.size() : found + mark.size();
  };
  if (text.substr(at).starts_with("<!--")) return after("-->");
  if (text.substr(at).starts_with("<![CDATA[")) return after("]]>");
  if (text.substr(at).starts_with("<?")) return after("?>");
  for (char quote = 0; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return text.size();
}

bool is_known_entity(std::string_view name) {
  constexpr std::string_view known[] = {"amp", "lt", "gt", "quot", "apos"};
  return name.starts_with('#') ||
         std::find(std::begin(known), std::end(known), name) != std::end(known);
}

/// A parser that expands no entities leaves unknown ones as they are, which is no reading either.
void refuse_unknown_entities(const SourceText& source, std::size_t start, std::string_view markup) {
  for (std::size_t at = markup.find('&'); at != std::string_view::npos;
       at = markup.find('&', at + 1)) {
    const std::string_view rest = markup.substr(at + 1);
    const std::string_view name = rest.substr(0, rest.find_first_of("; \t\r\n\"'<>&"));
    if (is_known_entity(name) && rest.substr(name.size()).starts_with(';')) continue;
    fail({source.name, line_at(source.text, start + at)},
         "the entity " + pliant::quoted("&" + std::string(name) + ";") +
             " is not known: only amp, lt, gt, quot, apos and numbers are");
  }
}

}  // namespace

void check_xml_text(const SourceText& source) {
  check_text(source);
  check_utf8(source);
  const std::string_view text = source.text;
  std::size_t depth = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    const std::size_t end = end_of_markup(text, at);
    const std::string_view markup = text.substr(at, end - at);
    if (markup.starts_with("<!DOCTYPE"))
      fail({source.name, line_at(text, at)}, "a document type (DTD) is not read");
    if (markup.starts_with("</")) {
      if (depth > 0) --depth;
    } else if (markup.size() > 1 && markup[1] != '!' && markup[1] != '?' &&
               !markup.ends_with("/>")) {
      if (++depth > deepest_xml)
        fail({source.name, line_at(text, at)},
             "elements are nested more than " + std::to_string(deepest_xml) + " deep");
    }
    if (!markup.starts_with("<!") && !markup.starts_with("<?"))
      refuse_unknown_entities(source, at, markup);
    at = end;
  }
}

LineIndex::LineIndex(std::string_view text) : starts_{0} {
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1))
    starts_.push_back(at + 1);
}

std::size_t LineIndex::line_of(std::size_t offset) const {
  return static_cast<std::size_t>(std::upper_bound(starts_.begin(), starts_.end(), offset) -
                                  starts_.begin());
}

std::size_t LineIndex::column_of(std::size_t offset) const {
  return offset - starts_[line_of(offset) - 1] + 1;
}

}  // namespace pliant
