// SPDX-License-Identifier: MIT
// Formats records of PDB files (wwPDB format 3.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"
#include "pliant/record/h5md/h5md_header.hpp"

namespace pliant {

/// Counts what did not fit, to be reported once for each kind.
struct PdbCuts {
  std::size_t atom_names = 0, residue_names = 0, chains = 0, bonds = 0;

  void tell(const std::string& file, const Log& log) const;
};

/// Records of one table of atoms, kept by reference. Throws InputError naming the atom whose
/// position, residue number or bond does not fit its columns.
class PdbText {
 public:
  /// `hybrid36_bonds`: bonds of atoms past 99,999 are written, too.
  PdbText(const AtomTable& atoms, bool hybrid36_bonds)
      : atoms_(atoms), hybrid36_bonds_(hybrid36_bonds) {}

  void add_title(const std::string& title);
  /// Adds a remark of up to 69 characters.
  void add_remark(const std::string& text);
  /// Serials are 1 to N in the order of the joints, hybrid-36 past 99,999. TER separates chains.
  /// `b_factors` (N) from -99.99 to 999.99; 0 if empty.
  void add_atoms(std::span<const Vec3> positions, std::span<const double> b_factors = {});
  /// Adds the atoms as a model, numbered from 1.
  void add_model(std::int64_t number, std::span<const Vec3> positions);
  void add_bonds(std::span<const RecordedBond> bonds);
  void add_end() { text_ += "END\n"; }
  /// Throws as add_atoms() if the atom does not fit; adds nothing.
  void check_atom(std::size_t atom, Vec3 position) const;

  const std::string& text() const { return text_; }
  void clear() { text_.clear(); }
  /// What did not fit since the object was made.
  const PdbCuts& cuts() const { return cuts_; }

 private:
  std::back_insert_iterator<std::string> out() { return std::back_inserter(text_); }
  void add_atom(std::size_t atom, Vec3 position, double b_factor);
  std::string number_columns(std::size_t atom) const;
  void check_position(std::size_t atom, Vec3 position) const;
  std::vector<std::vector<std::uint32_t>> neighbours(std::span<const RecordedBond> bonds);
  void add_conect(std::size_t atom, std::span<const std::uint32_t> others);

  const AtomTable& atoms_;
  bool hybrid36_bonds_;
  std::string text_;
  PdbCuts cuts_;
};

}  // namespace pliant
