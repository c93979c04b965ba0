// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_header.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/printable.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/perturb/force_files/force_header_reader.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr std::string_view escaped_characters = "%#\r\n";
constexpr std::array<std::string_view, 8> event_words{"force",     "step", "wander", "pin",
                                                      "hold_back", "cut",  "bar",    "restore"};

/// A value fills the rest of its line, where # would begin a comment.
std::string escaped(std::string_view value) {
  std::string text;
  for (char c : value) {
    if (escaped_characters.find(c) == std::string_view::npos) {
      text += c;
      continue;
    }
    const std::string code = fingerprint_text(static_cast<std::uint8_t>(c));
    text += "%" + code.substr(14);
  }
  return text;
}

std::string difference(const std::optional<std::int64_t>& expected, std::size_t found,
                       const char* what) {
  if (!expected || static_cast<std::uint64_t>(*expected) == found) return "";
  return std::to_string(*expected) + " " + what + ", not " + std::to_string(found);
}

}  // namespace

ForceHeader force_header_of(const Framework& framework) {
  ForceHeader header;
  header.joints = static_cast<std::int64_t>(framework.joint_count());
  header.bars = static_cast<std::int64_t>(framework.bar_count());
  return header;
}

std::string write_force_header(const ForceHeader& header) {
  std::string text = std::string(force_file_heading) + "\n";
  if (header.structure) text += "structure " + fingerprint_text(*header.structure) + "\n";
  if (header.joints) text += "joints " + std::to_string(*header.joints) + "\n";
  if (header.bars) text += "bars " + std::to_string(*header.bars) + "\n";
  for (const ForceSetting& one : header.input)
    text += "input " + one.name + " " + escaped(one.value) + "\n";
  return text;
}

std::string misfit(const ForceHeader& header, const Framework& framework) {
  const std::string joints = difference(header.joints, framework.joint_count(), "joints");
  return joints.empty() ? difference(header.bars, framework.bar_count(), "bars") : joints;
}

void check_fit(const ForceHeader& header, const Framework& framework, std::string_view file) {
  if (const std::string what = misfit(header, framework); !what.empty())
    throw InputError(printable_name(file) + ": was made for another framework: of " + what);
}

ForceHeader read_force_header(std::string_view text, std::string_view file) {
  ForceHeaderReader reader;
  for (Lines lines(text); lines.next();)
    if (!reader.take(words_of(lines.line()), lines.line(), {file, lines.number()})) break;
  reader.end(file);
  return reader.header;
}

bool has_force_events(std::string_view text) {
  for (Lines lines(text); lines.next();) {
    const Words words = words_of(lines.line());
    if (!words.empty() && std::ranges::count(event_words, words[0]) > 0) return true;
  }
  return false;
}

}  // namespace pliant
