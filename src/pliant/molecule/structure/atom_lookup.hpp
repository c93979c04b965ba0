// SPDX-License-Identifier: MIT
// Finding atoms by chain, residue number, insertion code and name, as LINK, SSBOND and struct_conn
// records name them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// How a record names an atom.
struct AtomAddress {
  std::string_view chain;
  std::int64_t number;
  char insertion_code;
  std::string_view name;
};

/// An index over a table, which must outlive it and not change.
class AtomLookup {
 public:
  explicit AtomLookup(const AtomTable& atoms);

  /// The atom at an address; nothing where there is none or several.
  std::optional<std::uint32_t> find(const AtomAddress& address) const;

 private:
  const AtomTable& atoms_;
  std::vector<std::uint32_t> first_atom_;  // (R + 1) of each residue
  std::vector<std::uint32_t> by_address_;  // residues, sorted by chain, number, insertion code
};

}  // namespace pliant
