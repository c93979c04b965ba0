// SPDX-License-Identifier: MIT
// The V3000 connection table of MDL molfiles: words after "M  V30 ", blocks between BEGIN and END.
#include "pliant/molecule/read/sdf/mol_v3000.hpp"

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {
namespace {

constexpr std::string_view prefix = "M  V30 ";

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!(line = trimmed(line)).empty()) {
    words.push_back(line.substr(0, line.find_first_of(" \t")));
    line.remove_prefix(words.back().size());
  }
  return words;
}

/// Reads one CTAB block.
class V3000Reader {
 public:
  V3000Reader(Lines& lines, MolBlock& block) : lines_(lines), block_(block) {}

  void read();

 private:
  bool next_logical_line();
  void take();
  void take_counts();
  using Setter = void (MolBlock::*)(std::size_t, std::int64_t, std::size_t);

  void take_atom();
  /// Takes the word KEY=VALUE from the words of an atom.
  void take_value(std::string_view key, std::string_view name, Setter set);
  void take_bond();
  std::size_t atom_of_word(std::size_t k);
  std::int64_t number_of_word(std::size_t k, std::string_view what);
  void need_words(std::size_t count, std::string_view what);
  void check_counts();
  [[noreturn]] void fail_here(const std::string& message) const {
    fail(block_.remarks().place(line_), message);
  }

  Lines& lines_;
  MolBlock& block_;
  std::string text_;  // of the logical line, without prefixes and continuation marks
  std::size_t line_ = 0;
  std::vector<std::string_view> words_;
  std::string section_;
  std::unordered_map<std::int64_t, std::size_t> atom_of_index_;
  std::optional<std::int64_t> stated_atoms_, stated_bonds_;
  std::size_t counts_line_ = 0;
};

/// Joins what "-" at the end of a line continues. False at M  END or the end of the record.
bool V3000Reader::next_logical_line() {
  text_.clear();
  for (bool first = true;; first = false) {
    if (!lines_.next() || !lines_.line().starts_with(prefix)) {
      if (first) return false;
      fail(block_.remarks().place(lines_.number()),
           "no line \"M  V30 ...\" continues the one before");
    }
    if (first) line_ = lines_.number();
    std::string_view part = trimmed(lines_.line().substr(prefix.size()));
    const bool continues = part.ends_with('-');
    if (continues) part.remove_suffix(1);
    text_ += part;
    if (!continues) return true;
  }
}

void V3000Reader::need_words(std::size_t count, std::string_view what) {
  if (words_.size() < count)
    fail_here(std::string(what) + " wanted, found " + std::to_string(words_.size()) +
              (words_.size() == 1 ? " word in " : " words in ") + pliant::quoted(text_));
}

std::int64_t V3000Reader::number_of_word(std::size_t k, std::string_view what) {
  const auto number = parse_integer(words_[k]);
  if (!number) fail_here(std::string(what) + " " + quoted(words_[k]) + " is not a whole number");
  return *number;
}

void V3000Reader::take_counts() {
  need_words(3, "COUNTS with atoms and bonds");
  stated_atoms_ = number_of_word(1, "atom count");
  stated_bonds_ = number_of_word(2, "bond count");
  counts_line_ = line_;
}

void V3000Reader::take_atom() {
  need_words(5, "atom index, symbol, x, y, z");
  const std::int64_t index = number_of_word(0, "atom index");
  const Place place = block_.remarks().place(line_);
  const Vec3 position{parse_coordinate(words_[2], place, "x"),
                      parse_coordinate(words_[3], place, "y"),
                      parse_coordinate(words_[4], place, "z")};
  if (!atom_of_index_.emplace(index, block_.size()).second)
    fail_here("atom index " + std::to_string(index) + " is given twice");
  block_.add_atom(words_[1], position, index, line_);
  take_value("CHG=", "charge", &MolBlock::set_charge);
  take_value("RAD=", "radical", &MolBlock::set_radical);
  take_value("MASS=", "isotope", &MolBlock::set_isotope);
}

void V3000Reader::take_value(std::string_view key, std::string_view name, Setter set) {
  for (std::string_view word : words_) {
    if (!word.starts_with(key)) continue;
    const auto value = parse_integer(word.substr(key.size()));
    if (!value) fail_here(std::string(name) + " " + quoted(word) + " is not a whole number");
    (block_.*set)(block_.size() - 1, *value, line_);
  }
}

std::size_t V3000Reader::atom_of_word(std::size_t k) {
  const std::int64_t index = number_of_word(k, "atom index");
  const auto found = atom_of_index_.find(index);
  if (found == atom_of_index_.end())
    fail_here("bond " + quoted(words_[0]) + ": atom index " + std::to_string(index) +
              " is none of the " + std::to_string(block_.size()) + " atoms");
  return found->second;
}

void V3000Reader::take_bond() {
  need_words(4, "bond index, type, two atoms");
  const std::int64_t type = number_of_word(1, "bond type");
  block_.add_bond(atom_of_word(2), atom_of_word(3), type, line_);
}

void V3000Reader::take() {
  words_ = words_of(text_);
  if (words_.empty()) return;
  if (words_[0] == "BEGIN" || words_[0] == "END") {
    section_ = words_[0] == "BEGIN" && words_.size() > 1 ? words_[1] : std::string_view();
  } else if (section_ == "ATOM") {
    take_atom();
  } else if (section_ == "BOND") {
    take_bond();
  } else if (words_[0] == "COUNTS") {
    take_counts();
  }
}

void V3000Reader::check_counts() {
  const auto check = [&](std::optional<std::int64_t> stated, std::size_t found,
                         const std::string& noun) {
    if (!stated || *stated == static_cast<std::int64_t>(found)) return;
    fail(block_.remarks().place(counts_line_), "COUNTS says " + std::to_string(*stated) + " " +
                                                   noun + ", found " + std::to_string(found));
  };
  check(stated_atoms_, block_.size(), "atoms");
  check(stated_bonds_, block_.bond_count(), "bonds");
}

void V3000Reader::read() {
  bool ended = false;
  while (!ended && next_logical_line()) {
    take();
    ended = words_.size() > 1 && words_[0] == "END" && words_[1] == "CTAB";
  }
  check_counts();
  // Templates of polymers may follow: they are no part of the molecule.
  while (lines_.line().starts_with(prefix) && lines_.next()) {
  }
  if (!lines_.line().starts_with("M  END"))
    block_.remarks().warn("no end", lines_.number(),
                          [] { return "no M  END line: taken as ended"; });
}

}  // namespace

void read_mol_v3000(Lines& lines, MolBlock& block) { V3000Reader(lines, block).read(); }

}  // namespace pliant
