// SPDX-License-Identifier: MIT
// How files of contacts speak of atoms: by the label that belongs to one atom alone ("A:LYS12:CA"),
// else by the index.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "pliant/base/error.hpp"
#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// Both ways between atoms and words. The table must outlive it and not change.
class AtomWords {
 public:
  explicit AtomWords(const AtomTable& atoms);

  /// The label of an atom if it has one of its own that is a word, else its index, from 0.
  std::string word_for(std::uint32_t atom) const;

  /// The atom of a word. Throws InputError at `place` if there is none or if several have the
  /// label.
  std::uint32_t find(std::string_view word, const Place& place) const;

 private:
  const AtomTable& atoms_;
  std::unordered_map<std::string, std::uint32_t> atom_of_;
  std::unordered_map<std::string, std::size_t> repeats_;  ///< labels of several atoms: how many
};

}  // namespace pliant
