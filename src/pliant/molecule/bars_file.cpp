// SPDX-License-Identifier: MIT
#include "pliant/molecule/bars_file.hpp"

#include <algorithm>
#include <limits>

#include "pliant/base/choices.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/text/file_text.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr std::string_view heading = "pliant-bars 1";
constexpr double infinity = std::numeric_limits<double>::infinity();
// What Framework and Sterics take (Angstrom).
constexpr double shortest_bar = 1e-150;
constexpr double furthest = 1e150;
constexpr double furthest_sterics = 1e5;

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

/// Reads a bars file line by line.
class Parser {
 public:
  Parser(std::string_view file, const Framework& joints)
      : place_{file, 0}, joints_(joints), names_(joints) {}

  BarsFile parse(std::string_view text) {
    for (Lines lines(text); lines.next();) {
      place_.line = lines.number();
      take(words_of(lines.line()), lines.line());
    }
    if (!headed_)
      fail({place_.file}, "expected the line " + quoted(heading) + " first, found no text");
    found_.sterics = sterics_.put_together(joints_, place_.file);
    return std::move(found_);
  }

 private:
  struct Statement {
    std::string_view name;
    std::size_t least_fields, most_fields;
    const char* fields;
    void (Parser::*take)(const Words&);
  };
  static std::span<const Statement> statements();

  void take(const Words& words, std::string_view line) {
    if (words.empty()) return;
    if (headed_) return take_statement(words);
    if (words.size() != 2 || words[0] != "pliant-bars" || words[1] != "1")
      fail(place_, "expected " + quoted(heading) + ", found " + quoted(trimmed(line)));
    headed_ = true;
  }

  void take_statement(const Words& words) {
    for (const Statement& row : statements()) {
      if (row.name != words[0]) continue;
      if (words.size() <= row.least_fields || words.size() > row.most_fields + 1)
        refuse(words, row.fields, std::to_string(words.size() - 1) + " fields");
      return (this->*row.take)(words);
    }
    fail(place_,
         "expected one of " + listed(names_of(statements())) + ", found " + quoted(words[0]));
  }

  void take_bars(const Words& words) {
    if (bars_line_ != 0)
      fail(place_, "bars: is given twice, first in line " + std::to_string(bars_line_));
    bars_line_ = place_.line;
    for (const BarChoice& row : bar_choices)
      if (row.name == words[1]) {
        found_.bars = row.kind;
        return;
      }
    refuse(words, "one of " + listed(names_of(bar_choices)), quoted(words[1]));
  }

  void take_bar(const Words& words) {
    const auto [a, b] = pair(words);
    StatedBar bar{{a, b}, std::nullopt};
    if (words.size() > 3) bar.length = number(words, 3, shortest_bar, furthest);
    const auto [row, is_new] = bar_lines_.emplace(std::minmax(a, b), place_.line);
    if (!is_new) fail(place_, "bar: is given twice, first in line " + std::to_string(row->second));
    found_.stated.push_back(bar);
  }

  void take_limit(const Words& words) {
    const auto [a, b] = pair(words);
    Limit limit{a, b, number(words, 3, 0.0, furthest)};
    limit.most = words[4] == "inf" ? infinity : number(words, 4, shortest_bar, furthest);
    if (limit.least > limit.most)
      refuse(words, "a least distance up to the most", quoted(words[3]));
    if (words.size() > 5) limit.kind = limit_kind(words);
    if (words.size() > 6) limit.energy = number(words, 6, -furthest, furthest);
    if (words.size() > 7) limit.group = std::uint32_t(whole(words, 7, no_limit_group - 1));
    found_.limits.push_back(limit);
  }

  void take_least(const Words& words) {
    sterics_.add_least(words[1], words[2], number(words, 3, 0.0, furthest_sterics), place_);
  }
  void take_kind(const Words& words) {
    sterics_.add_kind(names_.find(words[1], place_), words[2], place_);
  }
  void take_own(const Words& words) {
    const auto [a, b] = pair(words);
    sterics_.add_own(a, b, number(words, 3, 0.0, furthest_sterics), place_);
  }
  void take_bonds_apart(const Words& words) {
    sterics_.add_bonds_apart(static_cast<int>(whole(words, 1, 1000)), place_);
  }

  /// The second and third word as two different joints.
  Bar pair(const Words& words) const {
    const Joint a = names_.find(words[1], place_), b = names_.find(words[2], place_);
    if (a == b) refuse(words, "two joints", quoted(words[1]) + " twice");
    return {a, b};
  }

  double number(const Words& words, std::size_t k, double least, double most) const {
    const auto value = parse_real(words[k]);
    if (value && *value >= least && *value <= most) return *value;
    refuse(words, "a number from " + number_text(least) + " to " + number_text(most),
           quoted(words[k]));
  }

  std::int64_t whole(const Words& words, std::size_t k, std::int64_t most) const {
    const auto value = parse_integer(words[k]);
    if (value && *value >= 0 && *value <= most) return *value;
    refuse(words, "a whole number from 0 to " + std::to_string(most), quoted(words[k]));
  }

  LimitKind limit_kind(const Words& words) const {
    for (const LimitKindEntry& row : limit_kinds())
      if (row.name == words[5]) return row.kind;
    refuse(words, "a kind, one of " + listed(names_of(limit_kinds())), quoted(words[5]));
  }

  [[noreturn]] void refuse(const Words& words, const std::string& expected,
                           const std::string& found) const {
    fail(place_, std::string(words[0]) + ": expected " + expected + ", found " + found);
  }

  Place place_;
  const Framework& joints_;
  JointNames names_;
  bool headed_ = false;
  std::size_t bars_line_ = 0;
  std::map<std::pair<Joint, Joint>, std::size_t> bar_lines_;
  StericsLines sterics_;
  BarsFile found_;
};

std::span<const Parser::Statement> Parser::statements() {
  static constexpr Statement table[] = {
      {"bars", 1, 1, "bonds, angles or none", &Parser::take_bars},
      {"bar", 2, 3, "two joints and perhaps a length", &Parser::take_bar},
      {"limit", 4, 7, "two joints, least and most distance, and perhaps kind, energy and group",
       &Parser::take_limit},
      {"sterics", 3, 3, "two kinds and their least distance", &Parser::take_least},
      {"kind", 2, 2, "a joint and its kind", &Parser::take_kind},
      {"own", 3, 3, "two joints and their least distance", &Parser::take_own},
      {"bonds_apart", 1, 1, "one whole number", &Parser::take_bonds_apart}};
  return table;
}

/// Writes what a bars file holds, one kind of line after the other.
class Writer {
 public:
  explicit Writer(const Framework& joints) : joints_(joints), names_(joints) {}

  std::string write(const BarsFile& file) {
    line({heading});
    for (const BarChoice& row : bar_choices)
      if (row.kind == file.bars) line({"bars", row.name});
    for (const auto& [bar, length] : file.stated) {
      if (length) {
        line({"bar", word(bar.a), word(bar.b), shortest_text(*length)});
      } else {
        line({"bar", word(bar.a), word(bar.b)});
      }
    }
    for (const Limit& limit : file.limits) write_limit(limit);
    if (file.sterics) write_sterics(*file.sterics);
    return std::move(text_);
  }

 private:
  void write_limit(const Limit& limit) {
    const std::string most = limit.most == infinity ? "inf" : shortest_text(limit.most);
    const std::string group =
        limit.group == no_limit_group ? "" : " " + std::to_string(limit.group);
    line({"limit", word(limit.a), word(limit.b), shortest_text(limit.least), most, name(limit.kind),
          shortest_text(limit.energy) + group});
  }

  void write_sterics(const NamedSterics& named) {
    const auto& [sterics, kinds] = named;
    if (!sterics.units.empty() || !sterics.bonds.empty())
      throw InputError("bars file: no line can state units and bonds of sterics");
    for (std::size_t i = 0; i + 1 < kinds.size(); ++i)
      for (std::size_t j = i; j + 1 < kinds.size(); ++j)
        line({"sterics", kinds[i], kinds[j], shortest_text(sterics.least[i * kinds.size() + j])});
    for (Joint joint = 0; joint < joints_.joint_count(); ++joint)
      write_kind(joint, kinds[sterics.kinds[joint]], kinds);
    for (const OwnDistance& own : sterics.own)
      line({"own", word(own.a), word(own.b), shortest_text(own.least)});
    line({"bonds_apart", std::to_string(sterics.excluded_bonds)});
  }

  /// Writes nothing where the reader finds that kind by itself.
  void write_kind(Joint joint, std::string_view kind, const std::vector<std::string>& kinds) {
    const std::string_view usual = usual_kind(joints_, joint);
    const bool is_known = std::find(kinds.begin(), kinds.end(), usual) != kinds.end();
    if (kind != (is_known ? usual : "")) line({"kind", word(joint), kind.empty() ? no_kind : kind});
  }

  std::string word(Joint joint) const { return names_.word_for(joint, "bars file"); }

  void line(const std::vector<std::string_view>& words) {
    for (std::string_view word : words) (text_ += word) += ' ';
    text_.back() = '\n';
  }

  const Framework& joints_;
  JointNames names_;
  std::string text_;
};

/// Throws unless kinds are numbered and named as StericsLines does.
void check_names(const NamedSterics& named) {
  const std::vector<std::string>& kinds = named.kind_names;
  const bool fits = kinds.size() == named.sterics.kind_count && !kinds.empty() &&
                    kinds.back().empty() &&
                    std::is_sorted(kinds.begin(), kinds.end() - 1, std::less_equal<>()) &&
                    std::all_of(kinds.begin(), kinds.end() - 1, is_word) &&
                    std::find(kinds.begin(), kinds.end(), no_kind) == kinds.end();
  if (!fits)
    throw InputError("bars file: expected names of the kinds of joint, ascending, the last empty");
}

}  // namespace

BarsFile parse_bars_file(const SourceText& source, const Framework& joints) {
  return Parser(source.name, joints).parse(source.text);
}

BarsFile read_bars_file(const std::filesystem::path& path, const Framework& joints) {
  const std::string bytes = read_bytes(path);
  const std::string name = path_text(path);
  return parse_bars_file({name, without_byte_order_mark(bytes)}, joints);
}

std::string write_bars_file(const BarsFile& file, const Framework& joints) {
  if (file.sterics) {
    check(file.sterics->sterics, joints.joint_count());
    check_names(*file.sterics);
  }
  return Writer(joints).write(file);
}

bool is_bars_file(const std::string& bars) {
  const auto known = names_of(bar_choices);
  const bool is_name = std::find(known.begin(), known.end(), bars) != known.end();
  return !is_name && is_there(path_of(bars));
}

void take_bars(const std::string& bars, const Structure& structure, BuildOptions& options) {
  if (!is_bars_file(bars)) {
    options.bars = choose(bar_choices, "kind of bars (or bars file)", bars).kind;
    return;
  }
  const Framework joints({.joint_count = structure.size(),
                          .atoms = std::make_shared<const AtomTable>(structure.atoms)});
  BarsFile file = read_bars_file(path_of(bars), joints);
  options.bars = file.bars;
  options.stated = std::move(file.stated);
  options.stated_in = bars;
  options.limits = std::move(file.limits);
  if (file.sterics)
    options.sterics = std::make_shared<const Sterics>(std::move(file.sterics->sterics));
}

}  // namespace pliant
