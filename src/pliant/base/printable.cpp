// SPDX-License-Identifier: MIT
#include "pliant/base/printable.hpp"

#include <algorithm>
#include <cstdint>

namespace pliant {
namespace {

/// Bytes of the UTF-8 character that `text` begins with; 0 if it is none (RFC 3629).
std::size_t character_size(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t size = first < 0x80                    ? 1
                           : first >= 0xc2 && first < 0xe0 ? 2
                           : first >= 0xe0 && first < 0xf0 ? 3
                           : first >= 0xf0 && first < 0xf5 ? 4
                                                           : 0;
  if (size == 0 || text.size() < size) return 0;
  for (char c : text.substr(1, size - 1))
    if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) return 0;
  const auto second = static_cast<unsigned char>(size > 1 ? text[1] : 0);
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_no_scalar = (first == 0xed && second > 0x9f) || (first == 0xf4 && second > 0x8f);
  return is_overlong || is_no_scalar ? 0 : size;
}

/// C0, DEL and, in two bytes, C1.
bool is_control(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  const auto last = static_cast<unsigned char>(character.back());
  return character.size() == 1 ? first < 0x20 || first == 0x7f : first == 0xc2 && last < 0xa0;
}

void append_escaped(std::string& out, std::string_view bytes) {
  constexpr char hex[] = "0123456789abcdef";
  for (char byte : bytes) {
    const auto c = static_cast<unsigned char>(byte);
    out += {'\\', 'x', hex[c >> 4], hex[c & 15]};
  }
}

/// Escapes what is not printable, but the characters of `kept`.
std::string escaped(std::string_view text, std::string_view kept) {
  std::string out;
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(size, 1));
    const bool stays = size > 0 && (!is_control(character) || kept.find(character) != kept.npos);
    if (stays) {
      out += character;
    } else {
      append_escaped(out, character);
    }
    text.remove_prefix(character.size());
  }
  return out;
}

}  // namespace

std::string printable(std::string_view text) { return escaped(text, "\t\n"); }

std::string printable_name(std::string_view name) {
  std::string out = escaped(name, "");
  if (out == name && out.find('"') == out.npos) return out;
  std::string quoted = "\"";
  for (char c : out) quoted += c == '"' ? std::string("\\\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace pliant
