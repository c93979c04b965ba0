// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_conect.hpp"

#include <algorithm>
#include <optional>
#include <string>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"

namespace pliant {
namespace {

using Match = SerialIndex::Match;

/// A bond as one record states it.
struct Statement {
  std::uint32_t low, high;
  bool from_low;
};

/// Collects statements from one record after the other.
class ConectReader {
 public:
  ConectReader(const ConectTargets& targets, Remarks& remarks)
      : targets_(targets), remarks_(remarks) {}

  void take(const PdbLine& record);
  std::vector<Bond> bonds();

 private:
  std::optional<std::uint32_t> atom(std::string_view field, const PdbLine& record);
  std::optional<std::int64_t> serial(std::string_view field, const PdbLine& record);
  void warn_of_unknown(std::string_view field, std::int64_t serial, const PdbLine& record);
  void take_fields(const std::vector<std::string_view>& fields, const PdbLine& record);
  void take_unaligned(const PdbLine& record);
  bool is_atom(std::string_view field) const;

  const ConectTargets& targets_;
  Remarks& remarks_;
  std::vector<Statement> statements_;
  std::vector<std::string_view> fields_;
};

bool is_blank(std::string_view text) { return trimmed(text).empty(); }

/// Right-justified, without a blank or a tab inside and without leading zeros: what else fills five
/// columns is part of a longer number.
bool is_aligned(std::string_view field) {
  if (field.size() < 5 || field[4] == ' ') return false;
  const std::string_view number = trimmed(field);
  return number.find_first_of(" \t") == std::string_view::npos &&
         (number.size() == 1 || number[0] != '0');
}

/// Cuts columns 7-31 into their five fields; false where a field does not keep to its columns.
bool cut_columns(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (std::size_t first = 7; first <= 27; first += 5) {
    const std::string_view field = columns(line, first, first + 4);
    if (is_blank(field)) continue;
    if (!is_aligned(field)) return false;
    fields.push_back(field);
  }
  return true;
}

void cut_words(std::string_view rest, std::vector<std::string_view>& fields) {
  fields.clear();
  while (!(rest = trimmed(rest)).empty()) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    fields.push_back(word);
    rest.remove_prefix(word.size());
  }
}

std::optional<std::int64_t> ConectReader::serial(std::string_view field, const PdbLine& record) {
  const auto plain = parse_hybrid36(field);
  if (!targets_.hexadecimal) return plain;
  const auto hex = parse_hexadecimal(field);
  const bool plain_known = plain && targets_.atoms.find(*plain).match != Match::none;
  const bool hex_known = hex && *hex > 99999 && targets_.atoms.find(*hex).match != Match::none;
  if (plain_known && hex_known) {
    remarks_.warn("ambiguous serial", record.number, [&] {
      return "CONECT serial " + quoted(trimmed(field)) +
             " could be decimal or hexadecimal: bond left out";
    });
    return std::nullopt;
  }
  return hex_known ? hex : plain;
}

void ConectReader::warn_of_unknown(std::string_view field, std::int64_t serial,
                                   const PdbLine& record) {
  const bool is_ter =
      std::binary_search(targets_.ter_serials.begin(), targets_.ter_serials.end(), serial);
  remarks_.warn(is_ter ? "conect to ter" : "conect to nothing", record.number, [&] {
    return "CONECT names serial " + std::string(trimmed(field)) +
           (is_ter ? ", which is a TER record: bond left out"
                   : ", which no atom has: bond left out");
  });
}

std::optional<std::uint32_t> ConectReader::atom(std::string_view field, const PdbLine& record) {
  const auto number = serial(field, record);
  if (!number) {
    remarks_.warn("conect without number", record.number, [&] {
      return "CONECT field " + quoted(trimmed(field)) + " is not a serial number: bond left out";
    });
    return std::nullopt;
  }
  const auto found = targets_.atoms.find(*number);
  if (found.match == Match::none) warn_of_unknown(field, *number, record);
  if (found.match == Match::several)
    remarks_.warn("conect to several", record.number, [&] {
      return "CONECT names serial " + std::string(trimmed(field)) +
             ", which several atoms have: bond left out";
    });
  if (found.match != Match::one) return std::nullopt;
  return found.atom;
}

void ConectReader::take_fields(const std::vector<std::string_view>& fields, const PdbLine& record) {
  if (fields.empty()) return;
  const auto from = atom(fields[0], record);
  if (!from) return;
  for (std::size_t k = 1; k < fields.size(); ++k) {
    const auto to = atom(fields[k], record);
    if (!to) continue;
    if (*to == *from) {
      remarks_.warn("conect to itself", record.number, [&] {
        return "CONECT bonds serial " + std::string(trimmed(fields[0])) +
               " to itself: bond left out";
      });
      continue;
    }
    statements_.push_back({std::min(*from, *to), std::max(*from, *to), *from < *to});
  }
}

bool ConectReader::is_atom(std::string_view field) const {
  const auto number = parse_integer(field);
  return number && targets_.atoms.find(*number).match == Match::one;
}

void ConectReader::take_unaligned(const PdbLine& record) {
  cut_words(record.text.substr(6), fields_);
  const bool all = std::all_of(fields_.begin(), fields_.end(),
                               [&](std::string_view field) { return is_atom(field); });
  if (!all) {
    remarks_.warn("conect out of columns", record.number, [&] {
      return "CONECT " + quoted(record.text.substr(6)) +
             " is not in its columns and names serials that no atom has: left out";
    });
    return;
  }
  remarks_.warn("conect by words", record.number, [&] {
    return "CONECT " + quoted(record.text.substr(6)) +
           " is not in its columns: read as serials between blanks";
  });
  take_fields(fields_, record);
}

void ConectReader::take(const PdbLine& record) {
  if (!cut_columns(record.text, fields_)) {
    take_unaligned(record);
    return;
  }
  if (!is_blank(columns(record.text, 32, 61)))
    remarks_.warn("conect beyond bonds", record.number, [] {
      return "CONECT columns 32-61 (hydrogen bonds and salt bridges of old files) are left out";
    });
  take_fields(fields_, record);
}

std::vector<Bond> ConectReader::bonds() {
  std::sort(statements_.begin(), statements_.end(), [](const Statement& p, const Statement& q) {
    if (p.low != q.low) return p.low < q.low;
    return p.high != q.high ? p.high < q.high : p.from_low < q.from_low;
  });
  std::vector<Bond> bonds;
  bool any_multiple = false;
  for (auto first = statements_.begin(); first != statements_.end();) {
    const auto last = std::find_if(first, statements_.end(), [&](const Statement& s) {
      return s.low != first->low || s.high != first->high;
    });
    const auto from_low = std::count_if(first, last, [](const Statement& s) { return s.from_low; });
    const auto order = std::max(from_low, (last - first) - from_low);
    any_multiple = any_multiple || order > 1;
    bonds.push_back({first->low, first->high, BondOrigin::file,
                     static_cast<std::uint8_t>(order <= 3 ? order : 0)});
    first = last;
  }
  if (!any_multiple)
    for (Bond& bond : bonds) bond.order = 0;
  return bonds;
}

}  // namespace

std::vector<Bond> conect_bonds(const std::vector<PdbLine>& records, const ConectTargets& targets,
                               Remarks& remarks) {
  ConectReader reader(targets, remarks);
  for (const PdbLine& record : records) reader.take(record);
  return reader.bonds();
}

}  // namespace pliant
