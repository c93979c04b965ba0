// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/json_rows.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace pliant {
namespace {

constexpr std::string_view spaces = " \t\r\n";
constexpr std::string_view digits = "0123456789";

void append_utf8(std::uint32_t code, std::string& to) {
  const auto put = [&](std::uint32_t byte) { to += static_cast<char>(byte); };
  const auto put_rest = [&](int shift) { put(0x80 | ((code >> shift) & 0x3f)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xc0 | (code >> 6));
    put_rest(0);
  } else if (code < 0x10000) {
    put(0xe0 | (code >> 12));
    for (const int shift : {6, 0}) put_rest(shift);
  } else {
    put(0xf0 | (code >> 18));
    for (const int shift : {12, 6, 0}) put_rest(shift);
  }
}

/// Walks over the text, token by token.
class JsonReader {
 public:
  explicit JsonReader(const SourceText& source) : file_(source.name), text_(source.text) {}

  std::vector<JsonRow> rows_of(std::string_view list) {
    expect('{');
    const std::string name = text();
    if (name != list) refuse(pliant::quoted(list), pliant::quoted(name));
    expect(':');
    std::vector<JsonRow> rows;
    read_list('[', ']', [&] { rows.push_back(row()); });
    expect('}');
    skip_spaces();
    if (at_ < text_.size()) refuse("nothing more", found());
    return rows;
  }

 private:
  JsonRow row() {
    skip_spaces();
    JsonRow row{line_, {}};
    read_list('{', '}', [&] {
      std::string name = text();
      expect(':');
      std::string value = cell();
      if (!row.cells.emplace(name, std::move(value)).second)
        fail({file_, line_}, pliant::quoted(name) + " is given twice");
    });
    return row;
  }

  template <class Read>
  void read_list(char open, char close, Read read) {
    expect(open);
    if (next_is(close)) return expect(close);
    for (read(); next_is(','); read()) expect(',');
    expect(close);
  }

  std::string cell() {
    if (next_is('"')) return text();
    constexpr std::string_view null = "null";
    if (text_.substr(at_, null.size()) == null) {
      at_ += null.size();
      return {};
    }
    return number();
  }

  std::string number() {
    const std::size_t begin = at_;
    if (peek() == '-') ++at_;
    take_digits();
    if (peek() == '.') {
      ++at_;
      take_digits();
    }
    if (peek() == 'e' || peek() == 'E') {
      ++at_;
      if (peek() == '+' || peek() == '-') ++at_;
      take_digits();
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  void take_digits() {
    const std::size_t end = std::min(text_.find_first_not_of(digits, at_), text_.size());
    if (end == at_) refuse("a text, a number or null", found());
    at_ = end;
  }

  std::string text() {
    expect('"');
    std::string out;
    while (peek() != '"') {
      const char c = peek();
      if (at_ == text_.size() || static_cast<unsigned char>(c) < 0x20)
        refuse("\" at the end of a text", found());
      ++at_;
      if (c == '\\')
        take_escape(out);
      else
        out += c;
    }
    ++at_;
    return out;
  }

  void take_escape(std::string& out) {
    constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
    const char c = peek();
    const std::size_t known = at_ == text_.size() ? letters.npos : letters.find(c);
    if (known == letters.npos && c != 'u') refuse("a letter of an escape after \\", found());
    ++at_;
    if (known != letters.npos)
      out += meanings[known];
    else
      append_utf8(code_point(), out);
  }

  /// Characters beyond the first 65536 are pairs.
  std::uint32_t code_point() {
    const std::uint32_t first = hexadecimal();
    const bool is_pair = first >= 0xd800 && first < 0xdc00;
    if (first >= 0xdc00 && first < 0xe000) refuse("the first half of a pair before", "the second");
    if (!is_pair) return first;
    if (text_.substr(at_, 2) != "\\u") refuse("the second half of a pair", found());
    at_ += 2;
    const std::uint32_t second = hexadecimal();
    if (second < 0xdc00 || second >= 0xe000) refuse("the second half of a pair", "another");
    return 0x10000 + ((first - 0xd800) << 10) + (second - 0xdc00);
  }

  std::uint32_t hexadecimal() {
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k, ++at_) {
      const char c = peek();
      const bool is_letter = (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
      if (!is_letter && !(c >= '0' && c <= '9')) refuse("four hexadecimal digits", found());
      value = 16 * value + static_cast<std::uint32_t>(is_letter ? (c & 0x0f) + 9 : c - '0');
    }
    return value;
  }

  void skip_spaces() {
    for (; at_ < text_.size() && spaces.find(text_[at_]) != spaces.npos; ++at_)
      if (text_[at_] == '\n') ++line_;
  }

  bool next_is(char c) {
    skip_spaces();
    return peek() == c;
  }

  void expect(char c) {
    if (!next_is(c)) refuse(std::string(1, c), found());
    ++at_;
  }

  /// 0 at the end of the text.
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  std::string found() const {
    return at_ < text_.size() ? quoted(text_.substr(at_, 1)) : "the end of the text";
  }

  [[noreturn]] void refuse(const std::string& expected, const std::string& found) const {
    fail({file_, line_}, "expected " + expected + ", found " + found);
  }

  std::string_view file_, text_;
  std::size_t at_ = 0, line_ = 1;
};

}  // namespace

bool looks_like_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(spaces);
  return first != text.npos && (text[first] == '{' || text[first] == '[');
}

std::vector<JsonRow> parse_json_rows(const SourceText& source, std::string_view list) {
  return JsonReader(source).rows_of(list);
}

}  // namespace pliant
