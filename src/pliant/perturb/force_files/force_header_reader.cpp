// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_header_reader.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

std::optional<std::uint64_t> hexadecimal(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value, 16);
  if (text.size() != 16 || read.ec != std::errc() || read.ptr != end) return {};
  return value;
}

std::string unescaped(std::string_view text) {
  std::string value;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto code = text[k] == '%'
                          ? hexadecimal(std::string(14, '0') + std::string(text.substr(k + 1, 2)))
                          : std::nullopt;
    value += code ? static_cast<char>(*code) : text[k];
    if (code) k += 2;
  }
  return value;
}

void expect_one(const Words& words, const char* what, const Place& place) {
  if (words.size() != 2)
    fail(place, std::string(words[0]) + ": expected " + what + ", found " +
                    std::to_string(words.size() - 1) + " fields");
}

template <class Value>
void set(std::optional<Value>& fact, std::optional<Value> value, const Words& words,
         const char* what, const Place& place) {
  if (fact) fail(place, std::string(words[0]) + ": is given twice");
  if (!value)
    fail(place, std::string(words[0]) + ": expected " + what + ", found " + quoted(words[1]));
  fact = value;
}

void take_count(const Words& words, std::optional<std::int64_t>& fact, const Place& place) {
  constexpr const char* what = "a whole number from 0";
  expect_one(words, what, place);
  auto value = parse_integer(words[1]);
  if (value && *value < 0) value.reset();
  set(fact, value, words, what, place);
}

}  // namespace

bool ForceHeaderReader::take(const Words& words, std::string_view line, const Place& place) {
  if (words.empty()) return true;
  if (!is_headed_) {
    take_heading(words, line, place);
  } else if (is_over_) {
    return false;
  } else if (words[0] == "structure") {
    expect_one(words, "a fingerprint", place);
    set(header.structure, hexadecimal(words[1]), words, "16 hexadecimal digits", place);
  } else if (words[0] == "joints" || words[0] == "bars") {
    take_count(words, words[0] == "bars" ? header.bars : header.joints, place);
  } else if (words[0] == "input") {
    take_input(line, place);
  } else {
    is_over_ = true;
    return false;
  }
  return true;
}

void ForceHeaderReader::take_heading(const Words& words, std::string_view line,
                                     const Place& place) {
  if (words != words_of(force_file_heading))
    fail(place, "expected " + quoted(force_file_heading) + ", found " + quoted(trimmed(line)));
  is_headed_ = true;
}

void ForceHeaderReader::take_input(std::string_view line, const Place& place) {
  std::string_view rest = line.substr(0, line.find('#'));
  rest = trimmed(rest.substr(0, rest.find_last_not_of(" \t\r") + 1));
  rest = trimmed(rest.substr(std::string_view("input").size()));
  const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
  if (end == 0 || end == rest.size())
    fail(place, "input: expected a name and a value, found " + quoted(trimmed(line)));
  const std::string name(rest.substr(0, end));
  if (std::ranges::count(header.input, name, &ForceSetting::name) > 0)
    fail(place, "input " + name + ": is given twice");
  header.input.push_back({name, unescaped(trimmed(rest.substr(end))), place.line});
}

void ForceHeaderReader::end(std::string_view file) const {
  if (!is_headed_) fail({file}, "expected " + quoted(force_file_heading) + " first, found no text");
}

}  // namespace pliant
