// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_serials.hpp"

#include <algorithm>
#include <string>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"

namespace pliant {
namespace {

/// Columns 7-11, or as many digits as stand there from column 5 ("ATOM 100000") to 12.
std::string_view serial_field(std::string_view line) {
  const bool early = is_digit(column(line, 6)) && is_digit(column(line, 7));
  const bool late = is_digit(column(line, 12)) && is_digit(column(line, 11));
  return columns(line, early ? 5 : 7, late ? 12 : 11);
}

}  // namespace

std::optional<std::int64_t> PdbSerials::parse(std::string_view field, const PdbLine& line,
                                              Remarks& remarks) {
  if (hexadecimal_) {
    const auto value = parse_hexadecimal(field);
    if (value && *value > previous_) return value;
  }
  if (const auto value = parse_hybrid36(field)) return value;
  const auto value = parse_vmd_hexadecimal(field);
  if (value && !hexadecimal_) {
    remarks.warn("hexadecimal serials", line.number, [&] {
      return "serial numbers from " + quoted(field) + " on are read as hexadecimal";
    });
    hexadecimal_ = true;
  }
  return value;
}

void PdbSerials::warn_of_wrap(std::int64_t serial, const PdbLine& line, Remarks& remarks) const {
  if (previous_ != 99999 || serial > 1) return;
  remarks.warn("wrapped serials", line.number, [&] {
    return "serial numbers start again at " + std::to_string(serial) +
           " after 99999: atoms are taken in their order";
  });
}

std::int64_t PdbSerials::next(const PdbLine& line, Remarks& remarks) {
  const std::string_view field = serial_field(line.text);
  const auto serial = parse(field, line, remarks);
  given_ = serial.has_value();
  if (serial) {
    warn_of_wrap(*serial, line, remarks);
  } else {
    remarks.warn("no serial", line.number, [&] {
      return "serial number (columns 7-11) " + quoted(field) +
             " is not a number: the atom gets the next number, and CONECT cannot name it";
    });
  }
  return previous_ = serial.value_or(previous_ + 1);
}

SerialIndex::SerialIndex(const std::vector<std::int64_t>& serials, const std::vector<bool>& given) {
  entries_.reserve(serials.size());
  for (std::size_t i = 0; i < serials.size(); ++i)
    if (given[i]) entries_.push_back({serials[i], static_cast<std::uint32_t>(i)});
  const auto before = [](const Entry& p, const Entry& q) { return p.serial < q.serial; };
  if (!std::is_sorted(entries_.begin(), entries_.end(), before))
    std::stable_sort(entries_.begin(), entries_.end(), before);
}

SerialIndex::Found SerialIndex::find(std::int64_t serial) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), serial,
                                   [](const Entry& e, std::int64_t s) { return e.serial < s; });
  if (at == entries_.end() || at->serial != serial) return {Match::none, 0};
  const auto next = at + 1;
  const bool several = next != entries_.end() && next->serial == serial;
  return {several ? Match::several : Match::one, at->atom};
}

}  // namespace pliant
