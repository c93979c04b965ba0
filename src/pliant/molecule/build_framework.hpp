// SPDX-License-Identifier: MIT
// From chemistry to geometry: which pairs of atoms become bars, and how long they are.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Which pairs become bars: bonds (1-2), angles (1-2, 1-3, and 1-4 in planar groups), or none.
enum class BarKind : std::uint8_t { bonds, angles, none };

struct BarChoice {
  std::string_view name;
  BarKind kind;
  std::string_view summary;
};
inline constexpr BarChoice bar_choices[] = {
    {"bonds", BarKind::bonds, "a bar for each bond"},
    {"angles", BarKind::angles,
     "a bar for each bond, each pair of atoms bonded to one atom, and across planar groups"},
    {"none", BarKind::none, "no bar"}};

/// A bar between any two atoms, which replaces the bar that they may have already.
struct StatedBar {
  Bar bar;
  std::optional<double> length;  ///< Angstrom; by default the distance in the structure
  friend bool operator==(const StatedBar&, const StatedBar&) = default;
};

struct BuildOptions {
  BarKind bars = BarKind::bonds;
  std::string pin = "";                         ///< selection of atoms that never move; "": none
  bool use_masses = true;                       ///< give joints their atoms' masses (u)
  bool may_be_cut = false;                      ///< accept a molecule that a periodic box has cut
  std::vector<StatedBar> stated = {};           ///< in addition to `bars`; no pair twice
  std::vector<Limit> limits = {};               ///< joints are atoms
  std::shared_ptr<const Sterics> sterics = {};  ///< null: none
  std::shared_ptr<const TorsionPreferences> torsion_preferences = {};  ///< null: none
  std::string stated_in = "";  ///< file that states these bars, limits and sterics, for messages
};

/// The framework of a structure whose bonds are known. Throws InputError as refuse_cut() does
/// (unless the molecule may be cut, or bars are none), for a bar of length 0 (naming both atoms),
/// and for stated bars, limits and sterics that Framework refuses; OptionError for a bad selection.
Framework build_framework(const Structure& structure, const BuildOptions& options = {});

}  // namespace pliant
