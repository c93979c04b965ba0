// SPDX-License-Identifier: MIT
// The keywords of the selection language and what they test. Internal: users call selection.hpp.
#pragma once

#include <compare>
#include <string_view>
#include <vector>

#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant::selection {

/// A residue number with its insertion code (' ' for none), or an index.
struct Number {
  std::int64_t value = 0;
  char code = ' ';
  auto operator<=>(const Number&) const = default;
};

struct Range {
  Number first, last;
};

/// The atoms with data worked out once for each residue.
struct Subject {
  const AtomTable& atoms;
  std::vector<const ResidueTemplate*> shapes;  ///< (R)

  explicit Subject(const AtomTable& table) : atoms(table) {
    for (const Residue& residue : atoms.residues)
      shapes.push_back(find_residue_template(residue.name));
  }
  const Residue& residue(std::size_t i) const { return atoms.residues[atoms.residue_of[i]]; }
  bool is(std::size_t i, ResidueKind kind) const {
    const ResidueTemplate* shape = shapes[atoms.residue_of[i]];
    return shape && shape->kind == kind;
  }
  /// Joints of a graph are in no residue that has a name.
  bool is_graph() const { return atoms.residues.size() == 1 && atoms.residues[0].name.empty(); }
  bool is_protein(std::size_t i) const {
    return is(i, ResidueKind::amino_acid) || is(i, ResidueKind::cap);
  }
};

using Holds = bool (*)(const Subject&, std::size_t atom);
using Text = std::string_view (*)(const Subject&, std::size_t atom);
using NumberOf = Number (*)(const Subject&, std::size_t atom);

/// What a keyword tests: exactly one of these is set.
struct Meaning {
  Holds holds = nullptr;
  Text text = nullptr;
  NumberOf number = nullptr;
};

/// A keyword with what it tests.
struct Term {
  SelectionWord word;
  Meaning meaning;
};

/// The term of a keyword; null if there is none.
const Term* find_term(std::string_view word);

/// Whether `text` matches `pattern`, where * is any run of characters and ? any single one.
bool fits(std::string_view pattern, std::string_view text, bool any_case);

}  // namespace pliant::selection
