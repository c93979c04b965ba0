// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_assembly.hpp"

#include <algorithm>
#include <optional>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

constexpr std::string_view blank_chain = "NULL";

/// The text after "REMARK 350".
std::string_view remark_of(const PdbLine& line) { return trimmed(columns(line.text, 11, 80)); }

/// The name after "BIOMOLECULE:", if this is such a line.
std::optional<std::string_view> name_of(const PdbLine& line) {
  constexpr std::string_view begin = "BIOMOLECULE:";
  const std::string_view text = remark_of(line);
  if (!text.starts_with(begin)) return std::nullopt;
  return trimmed(text.substr(begin.size()));
}

std::vector<std::string_view> words_of(std::string_view text, char between) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(between, begin), text.size());
    if (const auto word = trimmed(text.substr(begin, end - begin)); !word.empty())
      words.push_back(word);
    begin = end + 1;
  }
  return words;
}

/// Reads the lines of one assembly.
class AssemblyReader {
 public:
  explicit AssemblyReader(const Remarks& remarks) : remarks_(remarks) {}

  void take(const PdbLine& line) {
    const std::string_view text = remark_of(line);
    const std::size_t chains = text.find("CHAINS:");
    if (chains != text.npos && (text.starts_with("APPLY") || text.starts_with("AND")))
      return take_chains(text.substr(chains + 7), text.starts_with("APPLY"));
    if (text.starts_with("BIOMT")) take_row(line, words_of(text, ' '));
  }

  Assembly finish(const PdbLine& last) {
    if (rows_ % 3 != 0) refuse(last, "expected three rows BIOMT1, BIOMT2 and BIOMT3, found fewer");
    return std::move(assembly_);
  }

 private:
  void take_chains(std::string_view names, bool is_new) {
    if (is_new || assembly_.empty()) assembly_.emplace_back();
    for (std::string_view name : words_of(names, ','))
      assembly_.back().chains.emplace_back(name == blank_chain ? std::string_view{} : name);
  }

  void take_row(const PdbLine& line, const std::vector<std::string_view>& words) {
    if (assembly_.empty()) refuse(line, "expected APPLY THE FOLLOWING TO CHAINS before BIOMT");
    const std::size_t row = rows_++ % 3;
    const std::string record = "BIOMT" + std::to_string(row + 1);
    if (words[0] != record) refuse(line, "expected " + record + ", found " + quoted(words[0]));
    if (words.size() != 6)
      refuse(line, record + ": expected a number and four values, found " +
                       std::to_string(words.size() - 1) + " words");
    if (row == 0) assembly_.back().motions.emplace_back();
    if (assembly_.back().motions.size() > most_motions)
      refuse(line, "expected at most " + std::to_string(most_motions) + " motions");
    RigidMotion& motion = assembly_.back().motions.back();
    for (std::size_t k = 0; k < 3; ++k) motion.turn[3 * row + k] = value(line, words[2 + k]);
    (row == 0   ? motion.shift.x
     : row == 1 ? motion.shift.y
                : motion.shift.z) = value(line, words[5]);
  }

  double value(const PdbLine& line, std::string_view word) const {
    const auto number = parse_real(word);
    if (!number) refuse(line, "BIOMT: expected a number, found " + quoted(word));
    return *number;
  }

  [[noreturn]] void refuse(const PdbLine& line, const std::string& what) const {
    fail(remarks_.place(line.number), "REMARK 350: " + what);
  }

  const Remarks& remarks_;
  Assembly assembly_;
  std::size_t rows_ = 0;
};

}  // namespace

std::vector<std::string> pdb_assembly_names(const std::vector<PdbLine>& remark_350) {
  std::vector<std::string> names;
  for (const PdbLine& line : remark_350)
    if (const auto name = name_of(line)) names.emplace_back(*name);
  return names;
}

Assembly pdb_assembly(const std::vector<PdbLine>& remark_350, const std::string& name,
                      const Remarks& remarks) {
  AssemblyReader reader(remarks);
  bool is_here = false;
  PdbLine last{};
  for (const PdbLine& line : remark_350) {
    if (const auto begun = name_of(line)) is_here = *begun == name;
    if (!is_here) continue;
    reader.take(line);
    last = line;
  }
  return reader.finish(last);
}

}  // namespace pliant
