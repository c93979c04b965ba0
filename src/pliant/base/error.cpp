// SPDX-License-Identifier: MIT
#include "pliant/base/error.hpp"

#include "pliant/base/printable.hpp"

namespace pliant {

std::string at(const Place& place, std::string_view message) {
  std::string text = printable_name(place.file);
  if (place.line > 0) text += ":" + std::to_string(place.line);
  return text.append(": ").append(message);
}

void fail(const Place& place, std::string_view message) { throw InputError(at(place, message)); }

std::string quoted(std::string_view text, std::size_t most) {
  constexpr char hex[] = "0123456789abcdef";
  std::string out = "\"";
  for (unsigned char c : text.substr(0, most)) {
    if (c == '"' || c == '\\') {
      out += {'\\', static_cast<char>(c)};
    } else if (c < 0x20 || c > 0x7e) {
      out += {'\\', 'x', hex[c >> 4], hex[c & 15]};
    } else {
      out += static_cast<char>(c);
    }
  }
  return out += text.size() > most ? "...\"" : "\"";
}

}  // namespace pliant
