// SPDX-License-Identifier: MIT
// How files of contacts refer to atoms: by label if it is unique ("A:LYS12:CA"), else by index.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>

#include "pliant/base/error.hpp"
#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// Translates between atoms and words. The table must outlive it and not change.
class AtomWords {
 public:
  explicit AtomWords(const AtomTable& atoms);

  /// The label of an atom if it is unique and a single word, else its index, from 0.
  std::string word_for(std::uint32_t atom) const;

  /// Returns the atom of a word. Throws InputError at `place` if there is none or if several have
  /// the label.
  std::uint32_t find(std::string_view word, const Place& place) const;

 private:
  const AtomTable& atoms_;
  std::unordered_map<std::string, std::uint32_t> atom_of_;
  /// labels that several atoms have, and how many
  std::unordered_map<std::string, std::size_t> repeats_;
};

}  // namespace pliant
