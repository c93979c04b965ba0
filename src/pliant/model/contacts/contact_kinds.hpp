// SPDX-License-Identifier: MIT
// The table of kinds of molecular contacts: how each is found and held, how many bars it counts as
// in the pebble game, what it is called and how it is drawn. Its rows are in
// framework/contact_kind_rows.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/contact_kind_rows.hpp"
#include "pliant/framework/limits.hpp"
#include "pliant/model/contacts/contact_options.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

struct MolecularContact;

enum class MolecularContactKind : std::uint8_t {
#define PLIANT_CONTACT_KIND(name, ...) name,
#include "pliant/framework/contact_kind_rows.hpp"
};

/// How a contact of atoms a and b is held, with a slack of so many Angstrom.
enum class ContactHold : std::uint8_t {
  /// D..A and H..A below the start, or what is usual, and the slack; H..B within 0.6 Angstrom of
  /// the start. Such contacts have a hydrogen and a base, and an energy each, by which they are
  /// diluted.
  by_hydrogen,
  both_ways,  ///< within the slack of the start
  below,      ///< below the start, or what is usual, and the slack
};

/// Finds the contacts of a structure whose bonds are known, sorted as sort() does.
using ContactFinder = std::vector<MolecularContact>(const Structure& structure,
                                                    const ContactOptions& options);

#define PLIANT_CONTACT_KIND(name, number, finder, ...) ContactFinder finder;
#include "pliant/framework/contact_kind_rows.hpp"

/// One row of the table of kinds of contact.
struct MolecularContactKindEntry {
  MolecularContactKind kind;
  std::string_view name;      ///< "hydrogen_bond", of files and options
  LimitKind limit;            ///< what its limits are recorded as
  ContactFinder* find;        ///< kinds that are found together have the same one
  std::string_view singular;  ///< "hydrogen bond", of text
  std::string_view plural;    ///< "hydrogen bonds"
  std::string_view summary;   ///< one line for help
  ContactHold hold;
  double slack;             ///< Angstrom
  std::uint8_t bars;        ///< in the pebble game, 1 to 6 (RigidityOptions changes them)
  std::string_view colour;  ///< "#3a9d8f", of the page and of viewers
  bool is_usual;            ///< whether it is found where nothing else is asked for

  /// Whether its contacts have a hydrogen and a base.
  bool has_hydrogen() const { return hold == ContactHold::by_hydrogen; }
};

/// All kinds, in the order of their numbers.
std::span<const MolecularContactKindEntry> molecular_contact_kinds();

/// The row of a kind.
const MolecularContactKindEntry& entry(MolecularContactKind kind);

std::string_view name(MolecularContactKind kind);

}  // namespace pliant
