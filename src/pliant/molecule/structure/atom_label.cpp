// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/atom_label.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/elements.hpp"
#include "pliant/base/letters.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

bool is_dummy(std::string_view word) {
  constexpr std::array<std::string_view, 9> dummies{"X",  "XX", "Xx", "Bq", "BQ",
                                                    "Du", "DU", "Gh", "LP"};
  return std::find(dummies.begin(), dummies.end(), word) != dummies.end();
}

std::string_view leading_letters(std::string_view label) {
  const auto end = std::find_if_not(label.begin(), label.end(), is_letter);
  return label.substr(0, static_cast<std::size_t>(end - label.begin()));
}

std::uint8_t element_of_beginning(std::string_view word) {
  if (word.size() == 1) return element_number(word);
  const std::uint8_t pair = element_number(word.substr(0, 2));
  if (is_lower(word[1])) return pair != 0 ? pair : element_number(word.substr(0, 1));
  return element_of_capitals(word[0], word[1]);
}

}  // namespace

std::uint8_t element_of_capitals(char first, char second) {
  const std::array<char, 2> both{first, second};
  const std::uint8_t single = element_number({both.data(), 1});
  const std::uint8_t pair = element_number({both.data(), 2});
  constexpr std::string_view organic = "HDCNOPS";  // whose labels carry letters for the position
  const bool sure = pair == 17 || organic.find(first) == std::string_view::npos;
  return pair != 0 && (sure || single == 0) ? pair : single;
}

LabelElement element_of_label(std::string_view label) {
  if (const auto number = parse_integer(label)) {
    const bool known = *number >= 1 && *number <= element_count;
    if (*number == 0) return {0, ElementSource::dummy};
    return known ? LabelElement{static_cast<std::uint8_t>(*number), ElementSource::number}
                 : LabelElement{};
  }
  if (const std::uint8_t element = element_number(label)) return {element, ElementSource::symbol};
  const std::string_view word = leading_letters(label);
  if (is_dummy(word)) return {0, ElementSource::dummy};
  if (word.empty()) return {};
  const std::uint8_t element = element_of_beginning(word);
  return element != 0 ? LabelElement{element, ElementSource::guessed} : LabelElement{};
}

}  // namespace pliant
