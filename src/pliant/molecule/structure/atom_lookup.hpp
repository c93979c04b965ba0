// SPDX-License-Identifier: MIT
// Finds atoms by chain, residue number, insertion code and name, as LINK, SSBOND and struct_conn
// records name them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// The address of an atom in a record.
struct AtomAddress {
  std::string_view chain;
  std::int64_t number;
  char insertion_code;
  std::string_view name;
};

/// An index of a table, which must outlive it and not change.
class AtomLookup {
 public:
  explicit AtomLookup(const AtomTable& atoms);

  /// The atom at an address; nothing if there is none or several.
  std::optional<std::uint32_t> find(const AtomAddress& address) const;

 private:
  const AtomTable& atoms_;
  std::vector<std::uint32_t> first_atom_;  // (R + 1) first atom of each residue
  std::vector<std::uint32_t> by_address_;  // residues, sorted by chain, number, insertion code
};

}  // namespace pliant
