// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/cif/mmcif_atoms.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <unordered_map>

#include "pliant/base/elements.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/read/shared/element_of_name.hpp"
#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {
namespace {

/// A column of the table, and the one to look at where its value is missing; absent where none of
/// the wanted tags is there.
struct Column {
  std::optional<std::size_t> index, fallback;
  std::string_view tag;
};

Column column_of(const CifTable& table, std::string_view tag, std::string_view other = "") {
  const auto first = table.column(tag), second = table.column(other);
  return first ? Column{first, second, tag} : Column{second, std::nullopt, other};
}

/// The columns that are read.
struct Columns {
  explicit Columns(const CifTable& table)
      : position{column_of(table, "cartn_x"), column_of(table, "cartn_y"),
                 column_of(table, "cartn_z")},
        name(column_of(table, "auth_atom_id", "label_atom_id")),
        residue(column_of(table, "auth_comp_id", "label_comp_id")),
        chain(column_of(table, "auth_asym_id", "label_asym_id")),
        number(column_of(table, "auth_seq_id", "label_seq_id")),
        insertion(column_of(table, "pdbx_pdb_ins_code")),
        instance(column_of(table, "label_asym_id")),
        element(column_of(table, "type_symbol")),
        serial(column_of(table, "id")),
        conformer(column_of(table, "label_alt_id")),
        occupancy(column_of(table, "occupancy")),
        b_factor(column_of(table, "b_iso_or_equiv")),
        charge(column_of(table, "pdbx_formal_charge")),
        model(column_of(table, "pdbx_pdb_model_num")) {}

  std::array<Column, 3> position;
  Column name, residue, chain, number, insertion, instance, element, serial, conformer, occupancy,
      b_factor, charge, model;
};

/// What makes atoms members of one residue: neighbours that share these.
struct ResidueWords {
  std::string_view residue, chain, number, insertion, instance;
  friend bool operator==(const ResidueWords&, const ResidueWords&) = default;
};

/// Reads the rows of an atom_site table.
class AtomSiteReader {
 public:
  AtomSiteReader(const CifDocument& document, const CifTable& table, Remarks& remarks)
      : document_(document),
        table_(table),
        remarks_(remarks),
        columns_(table),
        lines_(document.text) {}

  AtomSites read(std::size_t wanted, std::size_t& model_count);

 private:
  void check_columns() const;
  CifValue value(std::size_t row, const Column& column) const {
    return table_.at(row, *column.index);
  }
  /// "" where the column or the value is missing.
  std::string_view word(std::size_t row, const Column& column) const {
    if (!column.index) return {};
    const std::string_view word = document_.word(value(row, column));
    return word.empty() && column.fallback ? document_.word(table_.at(row, *column.fallback))
                                           : word;
  }
  Place place(std::size_t row, const Column& column) const {
    return remarks_.place(CifLines(document_.text)(value(row, column)));
  }
  std::size_t model_of(std::size_t row);
  void take(std::size_t row);
  Vec3 position(std::size_t row) const;
  void take_residue(std::size_t row);
  std::int64_t residue_number(std::size_t row, const ResidueWords& words) const;
  std::uint8_t element(std::size_t row);
  std::int64_t serial(std::size_t row);
  char conformer(std::size_t row);
  float occupancy(std::size_t row);
  void take_charge(std::size_t row);
  void take_instance();

  const CifDocument& document_;
  const CifTable& table_;
  Remarks& remarks_;
  Columns columns_;
  AtomSites sites_;
  ResidueWords words_;
  std::string_view first_name_;
  std::unordered_map<std::string_view, std::size_t> models_;
  std::unordered_map<std::string_view, std::uint32_t> instances_;
  std::string_view model_word_;
  std::size_t model_ = 0;
  CifLines lines_;
  std::size_t line_ = 1;  // where the current row begins
};

void AtomSiteReader::check_columns() const {
  const auto need = [&](const Column& column, std::string_view name) {
    if (!column.index)
      fail(remarks_.place(table_.line), "atom_site has no column " + std::string(name));
  };
  need(columns_.position[0], "Cartn_x");
  need(columns_.position[1], "Cartn_y");
  need(columns_.position[2], "Cartn_z");
  need(columns_.name, "label_atom_id (or auth_atom_id)");
}

std::size_t AtomSiteReader::model_of(std::size_t row) {
  const std::string_view word = this->word(row, columns_.model);
  if (model_ == 0 || word != model_word_) {
    model_word_ = word;
    model_ = models_.emplace(word, models_.size() + 1).first->second;
  }
  return model_;
}

Vec3 AtomSiteReader::position(std::size_t row) const {
  constexpr std::array<std::string_view, 3> names{"Cartn_x", "Cartn_y", "Cartn_z"};
  std::array<double, 3> xyz{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string_view raw = document_.raw(value(row, columns_.position[k]));
    const auto number = parse_real(without_uncertainty(raw));
    const bool fits = number && *number >= -largest_coordinate && *number <= largest_coordinate;
    xyz[k] = fits ? *number : parse_coordinate(raw, place(row, columns_.position[k]), names[k]);
  }
  return {xyz[0], xyz[1], xyz[2]};
}

std::int64_t AtomSiteReader::residue_number(std::size_t row, const ResidueWords& words) const {
  const auto& residues = sites_.structure.atoms.residues;
  if (words.number.empty()) {
    const bool goes_on = !residues.empty() && words_.number.empty() && words_.chain == words.chain;
    return goes_on ? residues.back().number + 1 : 1;
  }
  if (const auto number = parse_integer(words.number)) return *number;
  fail(place(row, columns_.number),
       std::string(columns_.number.tag) + " " + quoted(words.number) + " is not a whole number");
}

/// Atoms without a residue number (waters, by label) belong to one residue until the name of its
/// first atom comes again.
void AtomSiteReader::take_residue(std::size_t row) {
  AtomTable& atoms = sites_.structure.atoms;
  const ResidueWords words{word(row, columns_.residue), word(row, columns_.chain),
                           word(row, columns_.number), word(row, columns_.insertion),
                           word(row, columns_.instance)};
  const std::string_view name = word(row, columns_.name);
  const bool same =
      !atoms.residues.empty() && words == words_ && !(words.number.empty() && name == first_name_);
  if (!same) {
    const std::string_view residue = words.residue.empty() ? "UNK" : words.residue;
    atoms.residues.push_back({std::string(residue), residue_number(row, words),
                              words.insertion.empty() ? ' ' : words.insertion[0],
                              std::string(words.chain)});
    words_ = words;
    first_name_ = name;
    take_instance();
  }
  atoms.names.emplace_back(name);
  atoms.residue_of.push_back(static_cast<std::uint32_t>(atoms.residues.size() - 1));
  if (columns_.instance.index) sites_.instance_of.push_back(sites_.sections.back());
}

std::uint8_t AtomSiteReader::element(std::size_t row) {
  const std::string_view symbol = word(row, columns_.element);
  const std::string& name = sites_.structure.atoms.names.back();
  if (symbol.empty()) {
    const std::uint8_t guess =
        element_of_bare_name(name, sites_.structure.atoms.residues.back().name);
    remarks_.warn("element from name", line_, [&] {
      return "no type_symbol: element taken from the atom name, " + pliant::quoted(name) + " as " +
             std::string(element_symbol(guess));
    });
    return guess;
  }
  const std::uint8_t element = element_number(symbol);
  if (element == 0)
    remarks_.warn("unknown element", line_, [&] {
      return "type_symbol " + quoted(symbol) + " is not known: taken as unknown";
    });
  return element;
}

std::int64_t AtomSiteReader::serial(std::size_t row) {
  const auto number = parse_integer(word(row, columns_.serial));
  if (number) return *number;
  const auto& serials = sites_.structure.atoms.serials;
  if (columns_.serial.index)
    remarks_.warn("no serial", line_, [&] {
      return "atom_site id " + quoted(word(row, columns_.serial)) +
             " is not a whole number: the atom gets the next number";
    });
  return serials.empty() ? 1 : serials.back() + 1;
}

char AtomSiteReader::conformer(std::size_t row) {
  const std::string_view word = this->word(row, columns_.conformer);
  auto& labels = sites_.altlocs;
  if (word.size() > 1 && std::find(labels.begin(), labels.end(), word) == labels.end()) {
    constexpr std::size_t most = 31;
    if (labels.size() >= most)
      fail(place(row, columns_.conformer),
           "more than 31 alternate locations of several characters");
    labels.push_back(word);
  }
  return altloc_character(word, labels);
}

float AtomSiteReader::occupancy(std::size_t row) {
  const std::string_view word = this->word(row, columns_.occupancy);
  if (word.empty()) return 1.0F;
  if (const auto value = parse_real(without_uncertainty(word))) return static_cast<float>(*value);
  remarks_.warn("occupancy", line_,
                [&] { return "occupancy " + quoted(word) + " is not a number: left out"; });
  return 1.0F;
}

void AtomSiteReader::take_charge(std::size_t row) {
  const std::string_view word = this->word(row, columns_.charge);
  if (word.empty()) return;
  const auto charge = parse_integer(word);
  const bool fits = charge && *charge >= -15 && *charge <= 15;
  if (!fits)
    remarks_.warn("charge", line_, [&] {
      return "pdbx_formal_charge " + quoted(word) + " is not from -15 to 15: taken as 0";
    });
  if (!fits || *charge == 0) return;
  sites_.structure.charges.resize(sites_.size(), 0);
  sites_.structure.charges.back() = static_cast<std::int8_t>(*charge);
}

/// Takes the instance of a new run, which is its section, too.
void AtomSiteReader::take_instance() {
  sites_.unnumbered.push_back(words_.number.empty());
  if (!columns_.instance.index) return;
  const auto next = static_cast<std::uint32_t>(instances_.size());
  const auto [at, is_new] = instances_.emplace(words_.instance, next);
  if (is_new) sites_.instances.emplace_back(words_.instance);
  sites_.segments.push_back(words_.instance);
  sites_.sections.push_back(at->second);
  sites_.ended_sections = static_cast<std::uint32_t>(instances_.size());
}

void AtomSiteReader::take(std::size_t row) {
  line_ = lines_(table_.at(row, 0));
  sites_.structure.positions.push_back(position(row));
  take_residue(row);
  sites_.structure.atoms.serials.push_back(serial(row));
  sites_.structure.atoms.elements.push_back(element(row));
  sites_.conformers.push_back(conformer(row));
  sites_.occupancies.push_back(occupancy(row));
  const auto b_factor = parse_real(without_uncertainty(word(row, columns_.b_factor)));
  sites_.structure.b_factors.push_back(static_cast<float>(b_factor.value_or(0.0)));
  take_charge(row);
  sites_.lines.push_back(static_cast<std::uint32_t>(line_));
}

AtomSites AtomSiteReader::read(std::size_t wanted, std::size_t& model_count) {
  check_columns();
  for (std::size_t row = 0; row < table_.rows(); ++row)
    if (model_of(row) == wanted) take(row);
  model_count = models_.size();
  Structure& structure = sites_.structure;
  if (!structure.charges.empty()) structure.charges.resize(structure.size(), 0);
  return std::move(sites_);
}

}  // namespace

std::string_view without_uncertainty(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos || open == 0 || !text.ends_with(')')) return text;
  const std::string_view digits = text.substr(open + 1, text.size() - open - 2);
  const bool all = !digits.empty() && std::all_of(digits.begin(), digits.end(),
                                                  [](char c) { return c >= '0' && c <= '9'; });
  return all ? text.substr(0, open) : text;
}

char altloc_character(std::string_view label, std::span<const std::string_view> labels) {
  if (label.size() < 2) return label.empty() ? ' ' : label[0];
  const auto known = std::find(labels.begin(), labels.end(), label);
  return static_cast<char>(known == labels.end() ? 127 : 1 + (known - labels.begin()));
}

AtomSites read_atom_sites(const CifDocument& document, const CifTable& table, std::size_t wanted,
                          std::size_t& model_count, Remarks& remarks) {
  return AtomSiteReader(document, table, remarks).read(wanted, model_count);
}

}  // namespace pliant
