// SPDX-License-Identifier: MIT
// Serial numbers of PDB atoms: reads all the ways in which files overflow the five columns, and
// finds atoms for CONECT records.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"

namespace pliant {

/// Reads the serial numbers of a file's atoms, one after another.
class PdbSerials {
 public:
  /// The serial of an ATOM or HETATM record (columns 7-11, or 12 for six digits). If the field
  /// holds no number ("*****"), returns the previous serial plus 1 and warns once.
  std::int64_t next(const PdbLine& line, Remarks& remarks);

  /// Whether the file contains the last serial; only such serials can occur in CONECT records.
  bool last_was_given() const { return given_; }

  /// Whether serials have become hexadecimal, as VMD writes them.
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
  /// Takes the `serials` of the listed atoms; those whose `given` is false cannot be found.
  SerialIndex(const std::vector<std::int64_t>& serials, const std::vector<bool>& given);

  enum class Match { none, one, several };
  struct Found {
    Match match;
    std::uint32_t atom;  ///< valid if match is one
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
