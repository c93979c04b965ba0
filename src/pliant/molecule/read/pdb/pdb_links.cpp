// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_links.hpp"

#include <array>
#include <optional>
#include <string>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"

namespace pliant {
namespace {

/// Where a record keeps what it says of one end; 0 for no such column.
struct EndColumns {
  std::size_t name;       // four columns
  std::size_t conformer;  // one
  std::size_t residue;    // three, then two of the chain
  std::size_t number;     // four, then the insertion code
  std::size_t symmetry;   // six
};
using RecordColumns = std::array<EndColumns, 2>;
constexpr RecordColumns ssbond_columns{{{0, 0, 12, 18, 60}, {0, 0, 26, 32, 67}}};
constexpr RecordColumns link_columns{{{13, 17, 18, 23, 60}, {43, 47, 48, 53, 67}}};

std::optional<LinkEnd> end_of(std::string_view line, const EndColumns& at) {
  const auto number = parse_hybrid36(columns(line, at.number, at.number + 3));
  if (!number) return std::nullopt;
  LinkEnd end;
  end.address.chain = pdb_names(line, at.residue).chain;
  end.address.number = *number;
  end.address.insertion_code = column(line, at.number + 4);
  end.address.name = at.name == 0 ? "SG" : trimmed(columns(line, at.name, at.name + 3));
  end.conformer = at.conformer == 0 ? ' ' : column(line, at.conformer);
  const std::string_view symmetry = trimmed(columns(line, at.symmetry, at.symmetry + 5));
  if (symmetry != "1555") end.symmetry = symmetry;
  return end;
}

}  // namespace

std::vector<StatedLink> pdb_links(const std::vector<PdbLine>& records, Remarks& remarks) {
  std::vector<StatedLink> links;
  for (const PdbLine& record : records) {
    const bool is_link = record.text.starts_with("LINK");
    const RecordColumns& at = is_link ? link_columns : ssbond_columns;
    const auto first = end_of(record.text, at[0]), second = end_of(record.text, at[1]);
    if (!first || !second) {
      remarks.warn("link number", record.number, [&] {
        return std::string(is_link ? "LINK" : "SSBOND") +
               " record without two residue numbers in its columns: left out";
      });
      continue;
    }
    links.push_back({{*first, *second}, is_link ? "LINK" : "SSBOND", record.number, 1});
    if (is_link) links.back().order = 0;
  }
  return links;
}

}  // namespace pliant
