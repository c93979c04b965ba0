// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/reading.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "pliant/base/number.hpp"

namespace pliant {
namespace {

[[noreturn]] void fail_coordinate(std::string_view text, const Place& place, std::string_view field,
                                  std::string_view problem) {
  fail(place, std::string(field) + " " + quoted(text) + " " + std::string(problem));
}

bool has_decimal_comma(std::string_view text) {
  std::string with_point(text);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return with_point != text && parse_real(with_point).has_value();
}

bool all_at_one_point(const std::vector<Vec3>& positions) {
  return positions.size() > 1 &&
         std::all_of(positions.begin(), positions.end(), [&](Vec3 p) { return p == positions[0]; });
}

void warn_of_empty_bonds(const Structure& structure, Remarks& remarks) {
  for (const Bond& bond : structure.bonds) {
    if (structure.positions[bond.a] != structure.positions[bond.b]) continue;
    remarks.warn("empty bond", 0, [&] {
      return "the bonded atoms " + structure.atoms.label(bond.a) + " and " +
             structure.atoms.label(bond.b) + " lie at one point: the bond has length 0";
    });
  }
}

}  // namespace

double parse_coordinate(std::string_view text, const Place& place, std::string_view field) {
  const auto value = parse_real(text);
  if (!value) {
    if (trimmed(text).empty()) fail(place, std::string(field) + " is blank: a number is needed");
    fail_coordinate(text, place, field,
                    has_decimal_comma(text)
                        ? "is not a finite number: decimals begin with a point, not a comma"
                        : "is not a finite number");
  }
  if (std::abs(*value) > largest_coordinate)
    fail_coordinate(trimmed(text), place, field, "is too large: at most 1e9 Angstrom");
  return *value;
}

void take_model_count(Structure& structure, std::size_t count, const ReadOptions& options,
                      std::string_view noun, Remarks& remarks) {
  if (options.model > count)
    throw OptionError("no " + std::string(noun) + " " + std::to_string(options.model) + " in " +
                      std::string(remarks.file()) + ": it has " + std::to_string(count));
  structure.model = options.model;
  structure.model_count = count;
  if (count > 1)
    remarks.note(std::string(noun) + " " + std::to_string(options.model) + " of " +
                 std::to_string(count) + " used");
}

bool sort_bonds(std::vector<Bond>& bonds) {
  std::sort(bonds.begin(), bonds.end(), [](const Bond& p, const Bond& q) {
    if (p.a != q.a) return p.a < q.a;
    return p.b != q.b ? p.b < q.b : p.order > q.order;
  });
  const auto same_pair = [](const Bond& p, const Bond& q) { return p.a == q.a && p.b == q.b; };
  const auto end = std::unique(bonds.begin(), bonds.end(), same_pair);
  const bool merged = end != bonds.end();
  bonds.erase(end, bonds.end());
  return merged;
}

Structure finish(Structure structure, const SourceText& source, std::string_view format,
                 Remarks& remarks) {
  if (all_at_one_point(structure.positions))
    fail({source.name}, "all " + std::to_string(structure.size()) +
                            " atoms lie at one point: every bar would have length 0");
  warn_of_empty_bonds(structure, remarks);
  structure.source = source.name;
  structure.format = format;
  remarks.tell();
  return structure;
}

}  // namespace pliant
