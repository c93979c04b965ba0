// SPDX-License-Identifier: MIT
// Serial numbers of PDB atoms: read in every way that files overflow their five columns, and looked
// up by the CONECT records.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"

namespace pliant {

/// Reads the serial numbers of a file's atoms, one after the other.
class PdbSerials {
 public:
  /// The serial of an ATOM or HETATM record (columns 7-11; 12 where it has six digits). Where the
  /// field holds no number ("*****") it is the one before plus 1, warned of once.
  std::int64_t next(const PdbLine& line, Remarks& remarks);

  /// Whether next() gave a number that the file holds, as CONECT can name no other.
  bool last_was_given() const { return given_; }

  /// Whether numbers are hexadecimal from some atom on, as VMD writes them.
  bool hexadecimal() const { return hexadecimal_; }

 private:
  std::optional<std::int64_t> parse(std::string_view field, const PdbLine& line, Remarks& remarks);
  void warn_of_wrap(std::int64_t serial, const PdbLine& line, Remarks& remarks) const;

  std::int64_t previous_ = 0;
  bool given_ = true;
  bool hexadecimal_ = false;
};

/// Finds atoms by serial number.
class SerialIndex {
 public:
  /// `serials` of the listed atoms; those where `given` is false cannot be found.
  SerialIndex(const std::vector<std::int64_t>& serials, const std::vector<bool>& given);

  enum class Match { none, one, several };
  struct Found {
    Match match;
    std::uint32_t atom;  ///< where match is one
  };
  Found find(std::int64_t serial) const;

 private:
  struct Entry {
    std::int64_t serial;
    std::uint32_t atom;
  };
  std::vector<Entry> entries_;  // sorted by serial
};

}  // namespace pliant
