// SPDX-License-Identifier: MIT
#include "pliant/sample/pocket/held_contacts.hpp"

#include <algorithm>
#include <string_view>

#include "pliant/base/choices.hpp"

namespace pliant {
namespace {

constexpr std::string_view all = "all", none = "none";

constexpr std::string_view words[] = {
#define PLIANT_CONTACT_KIND(name, ...) #name,
#include "pliant/framework/contact_kind_rows.hpp"
    all, none};

bool names(std::span<const std::string> hold, std::string_view name) {
  return std::ranges::find(hold, name) != hold.end();
}

/// Whether a carbon has nothing but nitrogen that bears hydrogen, and maybe a substituent, around
/// it: guanidinium, amidinium, imidazolium.
bool shares_charge(const BondChemistry& chemistry, Joint carbon) {
  int nitrogens = 0;
  for (const Link& bond : chemistry.bonds_at(carbon)) {
    if (chemistry.is_oxygen(bond.node)) return false;
    if (!chemistry.is_nitrogen(bond.node)) continue;
    const auto around = chemistry.bonds_at(bond.node);
    if (std::ranges::none_of(around,
                             [&](const Link& at) { return chemistry.is_hydrogen(at.node); }))
      return false;
    ++nitrogens;
  }
  return nitrogens > 1;
}

bool is_cation(const BondChemistry& chemistry, Joint atom) {
  if (!chemistry.is_nitrogen(atom)) return false;
  const auto bonds = chemistry.bonds_at(atom);
  return bonds.size() == 4 || std::ranges::any_of(bonds, [&](const Link& bond) {
           return shares_charge(chemistry, bond.node);
         });
}

/// Oxygen of carboxylate, phosphate or sulfonate, which has three that are terminal; a sulfone with
/// two has no charge.
bool is_anion(const BondChemistry& chemistry, Joint atom) {
  const auto is_terminal = [&](Joint at) {
    return chemistry.is_oxygen(at) && chemistry.bonds_at(at).size() == 1;
  };
  if (!is_terminal(atom)) return false;
  constexpr std::uint8_t carbon = 6, phosphorus = 15, sulphur = 16;
  const Joint centre = chemistry.bonds_at(atom)[0].node;
  const auto terminal = std::ranges::count_if(
      chemistry.bonds_at(centre), [&](const Link& bond) { return is_terminal(bond.node); });
  const std::uint8_t element = chemistry.element(centre);
  if (element == sulphur) return terminal > 2;
  return terminal > 1 && (element == carbon || element == phosphorus);
}

/// Of a bond by hydrogen the limit of donor and acceptor tells.
bool is_salt_bridge(const BondChemistry& chemistry, const Limit& limit) {
  return (is_cation(chemistry, limit.a) && is_anion(chemistry, limit.b)) ||
         (is_cation(chemistry, limit.b) && is_anion(chemistry, limit.a));
}

bool is_of_kind(const BondChemistry& chemistry, const Limit& limit,
                std::span<const std::string> hold) {
  if (names(hold, all)) return true;
  if (limit.kind != LimitKind::hydrogen_bond) return names(hold, name(limit.kind));
  return names(hold, is_salt_bridge(chemistry, limit) ? "salt_bridge" : "hydrogen_bond");
}

}  // namespace

std::string hold_names(std::string_view quotes) {
  std::string text;
  for (const std::string_view word : words) {
    if (!text.empty()) text += word == none ? " or " : ", ";
    text.append(quotes).append(word).append(quotes);
  }
  return text;
}

void check_hold(std::span<const std::string> hold) {
  for (const std::string& word : hold)
    if (std::ranges::find(words, word) == std::end(words))
      throw OptionError("hold: " +
                        unknown_choice("kind of contact", word, {words, std::end(words)}));
}

std::vector<std::uint8_t> held_contacts(const Framework& framework, const BondChemistry& chemistry,
                                        const std::vector<bool>& is_ligand,
                                        std::span<const std::string> hold) {
  const auto limits = framework.limits();
  std::vector<std::uint8_t> held(limits.size(), 0);
  std::vector<std::uint32_t> groups;
  std::vector<bool> is_metal_of(is_ligand);  // what a held metal joins
  const auto hold_one = [&](std::size_t k) {
    held[k] = 1;
    if (limits[k].group != no_limit_group) groups.push_back(limits[k].group);
    if (limits[k].kind == LimitKind::metal)
      is_metal_of[limits[k].a] = is_metal_of[limits[k].b] = true;
  };
  for (std::size_t k = 0; k < limits.size(); ++k)
    if ((is_ligand[limits[k].a] || is_ligand[limits[k].b]) &&
        is_of_kind(chemistry, limits[k], hold))
      hold_one(k);
  std::ranges::sort(groups);
  for (std::size_t k = 0; k < limits.size(); ++k) {
    const bool is_at_metal = limits[k].kind == LimitKind::metal && held[k] == 0 &&
                             (is_metal_of[limits[k].a] || is_metal_of[limits[k].b]);
    if (std::ranges::binary_search(groups, limits[k].group) ||
        (is_at_metal && (names(hold, all) || names(hold, "metal"))))
      held[k] = 1;
  }
  return held;
}

}  // namespace pliant
