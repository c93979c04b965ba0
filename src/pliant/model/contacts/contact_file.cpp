// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/contact_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <tuple>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/model/atoms/atom_words.hpp"
#include "pliant/model/contacts/json_rows.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

constexpr double furthest = 1e5;  // Angstrom

/// A column of numbers: what it is called, and where a contact has it.
struct NumberColumn {
  std::string_view name;
  double MolecularContact::*place;
  double least, most;
  bool is_of_hydrogens;  ///< empty for kinds without a hydrogen
};
constexpr std::array<NumberColumn, 7> number_columns{
    {{"energy", &MolecularContact::energy, -1e6, 0.0, false},
     {"distance", &MolecularContact::distance, 0.0, furthest, false},
     {"least", &MolecularContact::least, 0.0, furthest, false},
     {"most", &MolecularContact::most, 0.0, furthest, false},
     {"hydrogen_most", &MolecularContact::hydrogen_most, 0.0, furthest, true},
     {"base_least", &MolecularContact::base_least, 0.0, furthest, true},
     {"base_most", &MolecularContact::base_most, 0.0, furthest, true}}};

/// A column of atoms.
struct AtomColumn {
  std::string_view name;
  std::uint32_t MolecularContact::*place;
  bool is_of_hydrogens;
};
constexpr std::array<AtomColumn, 4> atom_columns{{{"a", &MolecularContact::a, false},
                                                  {"b", &MolecularContact::b, false},
                                                  {"hydrogen", &MolecularContact::hydrogen, true},
                                                  {"base", &MolecularContact::base, true}}};

std::vector<std::string_view> column_names() {
  std::vector<std::string_view> names{"kind"};
  for (const AtomColumn& column : atom_columns) names.push_back(column.name);
  for (const NumberColumn& column : number_columns) names.push_back(column.name);
  return names;
}

/// Atoms as words, and the words of a contact in the order of the columns; "" for none.
class ContactWords {
 public:
  explicit ContactWords(const Structure& structure) : names_(structure.atoms) {}

  std::vector<std::string> of(const MolecularContact& contact) const {
    const bool has_hydrogen = entry(contact.kind).has_hydrogen();
    std::vector<std::string> words{std::string(name(contact.kind))};
    for (const AtomColumn& column : atom_columns)
      words.push_back(
          column.is_of_hydrogens && !has_hydrogen ? "" : names_.word_for(contact.*column.place));
    for (const NumberColumn& column : number_columns)
      words.push_back(
          column.is_of_hydrogens && !has_hydrogen ? "" : shortest_text(contact.*column.place));
    return words;
  }

 private:
  AtomWords names_;
};

/// Spreadsheets take a cell that begins so for a formula; an apostrophe makes it text.
constexpr std::string_view formula_marks = "=+-@'";

/// A cell of text that no spreadsheet runs.
std::string harmless(const std::string& text) {
  const bool is_risky = !text.empty() && formula_marks.find(text.front()) != std::string_view::npos;
  return is_risky ? "'" + text : text;
}

/// The text that `harmless` was given.
std::string_view without_apostrophe(std::string_view cell) {
  const bool is_made = cell.size() > 1 && cell.front() == '\'' &&
                       formula_marks.find(cell[1]) != std::string_view::npos;
  return is_made ? cell.substr(1) : cell;
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back(without_apostrophe(trimmed(line.substr(begin, end - begin))));
    begin = end + 1;
  }
  return cells;
}

/// Reads a table of contacts: CSV line by line, or JSON object by object.
class Parser {
 public:
  Parser(std::string_view file, const Structure& structure)
      : place_{file, 0}, structure_(structure), names_(structure.atoms) {}

  std::vector<MolecularContact> parse_json(std::string_view text) {
    for (const JsonRow& row : parse_json_rows({place_.file, text}, "contacts")) {
      place_.line = row.line;
      take_row(row);
    }
    sort(found_);
    return std::move(found_);
  }

  std::vector<MolecularContact> parse(std::string_view text) {
    for (Lines lines(text); lines.next();) {
      place_.line = lines.number();
      const std::string_view line = trimmed(lines.line());
      if (line.empty() || line.front() == '#') continue;
      columns_.empty() ? take_heading(line) : take_line(line);
    }
    if (columns_.empty())
      fail({place_.file}, "expected a line of column names with kind, a and b, found no text");
    sort(found_);
    return std::move(found_);
  }

 private:
  void take_row(const JsonRow& row) {
    columns_.clear();
    cells_.clear();
    const std::vector<std::string_view> known = column_names();
    for (const auto& [name, value] : row.cells) {
      if (std::find(known.begin(), known.end(), name) == known.end())
        fail(place_, unknown_choice("column", name, known));
      columns_.emplace(name, cells_.size());
      cells_.push_back(value);
    }
    for (std::string_view needed : {"kind", "a", "b"})
      if (!columns_.contains(needed)) fail(place_, "there is no " + quoted(needed));
    take_contact();
  }

  void take_heading(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line);
    const std::vector<std::string_view> known = column_names();
    for (std::size_t k = 0; k < cells.size(); ++k) {
      if (std::find(known.begin(), known.end(), cells[k]) == known.end())
        fail(place_, unknown_choice("column", cells[k], known));
      if (!columns_.emplace(cells[k], k).second)
        fail(place_, "column " + quoted(cells[k]) + " is given twice");
    }
    for (std::string_view needed : {"kind", "a", "b"})
      if (!columns_.contains(needed)) fail(place_, "there is no column " + quoted(needed));
  }

  void take_line(std::string_view line) {
    cells_ = cells_of(line);
    if (cells_.size() != columns_.size())
      fail(place_, "expected " + std::to_string(columns_.size()) + " fields, found " +
                       std::to_string(cells_.size()));
    take_contact();
  }

  void take_contact() {
    MolecularContact contact;
    contact.kind = kind();
    const bool has_hydrogen = entry(contact.kind).has_hydrogen();
    for (const AtomColumn& column : atom_columns)
      if (!column.is_of_hydrogens || has_hydrogen) contact.*column.place = atom(column.name);
    refuse_repeats(contact);
    contact.energy = -1.0;
    set_limits(contact, structure_);
    for (const NumberColumn& column : number_columns)
      if (!cell(column.name).empty()) contact.*column.place = number(column);
    check_interval(contact);
    found_.push_back(contact);
  }

  std::string_view cell(std::string_view column) const {
    const auto at = columns_.find(column);
    return at == columns_.end() ? std::string_view{} : cells_[at->second];
  }

  MolecularContactKind kind() const {
    for (const auto& row : molecular_contact_kinds())
      if (row.name == cell("kind")) return row.kind;
    fail(place_,
         unknown_choice("kind of contact", cell("kind"), names_of(molecular_contact_kinds())));
  }

  std::uint32_t atom(std::string_view column) const {
    if (cell(column).empty())
      fail(place_, std::string(column) + ": expected an atom, found nothing");
    return names_.find(cell(column), place_);
  }

  double number(const NumberColumn& column) const {
    const auto value = parse_real(cell(column.name));
    if (value && *value >= column.least && *value <= column.most) return *value;
    fail(place_, std::string(column.name) + ": expected a number from " +
                     number_text(column.least) + " to " + number_text(column.most) + ", found " +
                     quoted(cell(column.name)));
  }

  /// Two hydroxyls may bind each other twice, each by its hydrogen.
  void refuse_repeats(const MolecularContact& contact) {
    if (contact.a == contact.b) fail(place_, "a, b: expected two atoms, found one twice");
    const auto [low, high] = std::minmax(contact.a, contact.b);
    const auto [row, is_new] = lines_.emplace(std::tuple{low, high, contact.hydrogen}, place_.line);
    if (is_new) return;
    const bool has_hydrogen = entry(contact.kind).has_hydrogen();
    fail(place_, std::string(has_hydrogen ? "a, b, hydrogen: these three" : "a, b: these two") +
                     " are in contact already, by line " + std::to_string(row->second));
  }

  void check_interval(const MolecularContact& contact) const {
    if (contact.least > contact.most)
      fail(place_, "least: expected at most " + number_text(contact.most) + ", found " +
                       quoted(cell("least")));
    if (contact.base_least > contact.base_most)
      fail(place_, "base_least: expected at most " + number_text(contact.base_most) + ", found " +
                       quoted(cell("base_least")));
  }

  Place place_;
  const Structure& structure_;
  AtomWords names_;
  std::map<std::string, std::size_t, std::less<>> columns_;
  std::vector<std::string_view> cells_;
  /// The line on which a pair of atoms and its hydrogen stood.
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::size_t> lines_;
  std::vector<MolecularContact> found_;
};

std::string json_text(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string escaped = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') escaped += '\\';
    if (static_cast<unsigned char>(c) >= 0x20)
      escaped += c;
    else
      ((escaped += "\\u00") += digits[(c >> 4) & 0xf]) += digits[c & 0xf];
  }
  return escaped + "\"";
}

}  // namespace

std::string contacts_as_csv(const std::vector<MolecularContact>& contacts,
                            const Structure& structure) {
  std::string text;
  for (std::string_view column : column_names()) (text += column) += ',';
  text.back() = '\n';
  const ContactWords words(structure);
  for (const MolecularContact& contact : contacts) {
    const std::vector<std::string> cells = words.of(contact);
    for (std::size_t c = 0; c < cells.size(); ++c)
      (text += c <= atom_columns.size() ? harmless(cells[c]) : cells[c]) += ',';
    text.back() = '\n';
  }
  return text;
}

std::string contacts_as_json(const std::vector<MolecularContact>& contacts,
                             const Structure& structure) {
  const ContactWords words(structure);
  const std::vector<std::string_view> columns = column_names();
  std::string text = "{\"contacts\": [";
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::vector<std::string> cells = words.of(contacts[k]);
    text += k == 0 ? "\n  {" : ",\n  {";
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const bool is_text = c <= atom_columns.size();  // the kind, then atoms
      text += (c > 0 ? ", " : "") + json_text(columns[c]) + ": ";
      text += cells[c].empty() ? "null" : is_text ? json_text(cells[c]) : cells[c];
    }
    text += '}';
  }
  return text + "\n]}\n";
}

std::vector<MolecularContact> parse_contacts(const SourceText& source, const Structure& structure) {
  Parser parser(source.name, structure);
  return looks_like_json(source.text) ? parser.parse_json(source.text) : parser.parse(source.text);
}

std::vector<MolecularContact> read_contacts(const std::filesystem::path& path,
                                            const Structure& structure) {
  const std::string bytes = read_bytes(path);
  const std::string name = path_text(path);
  return parse_contacts({name, without_byte_order_mark(bytes)}, structure);
}

}  // namespace pliant
