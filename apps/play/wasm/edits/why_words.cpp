// SPDX-License-Identifier: MIT
#include "edits/why_words.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "edits/pair_words.hpp"
#include "edits/ring_words.hpp"
#include "pliant/base/number.hpp"

namespace pliant::play {
namespace {

/// A joint that goes so far in the trial steps is not held.
constexpr double not_held = 0.5;  // Angstrom

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/// "hydrophobic contacts": the table of kinds has the word, others take an s.
std::string plural_of(const std::string& singular) {
  for (const MolecularContactKindEntry& row : molecular_contact_kinds())
    if (row.singular == singular) return std::string(row.plural);
  return singular + "s";
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const bool is_last = k + 1 == parts.size();
    text += (k == 0 ? "" : is_last ? " and " : ", ") + parts[k];
  }
  return text;
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

/// Angstrom with two digits: trial steps tell no more.
std::string length_text(double length) {
  return number_text(0.01 * double(long(100.0 * length + 0.5)), 4) + " Å";
}

}  // namespace

std::vector<HolderLine> HeldWords::lines() const {
  std::vector<HolderLine> all;
  if (held.is_pinned)
    all.push_back({"pin of " + start.atoms.label(joint), "pin", joint, joint, 1.0, false});
  for (const Holder& holder : held.holders) {
    const std::string a = start.atoms.label(holder.a), b = start.atoms.label(holder.b);
    if (holder.kind == Holder::Kind::pin) {
      all.push_back({"pin of " + a, "pin", holder.a, holder.b, holder.load, false});
    } else if (holder.kind == Holder::Kind::pressed) {
      all.push_back({a + " touches " + b, "touch", holder.a, holder.b, holder.load, false});
    } else {
      const std::string what = what_joins(start, framework, holder.a, holder.b);
      all.push_back({what + " " + a + " – " + b, what, holder.a, holder.b, holder.load, true});
    }
  }
  return all;
}

/// "3 hydrogen bonds, 1 hydrophobic contact and a pin".
std::string HeldWords::carried(Which which) const {
  std::vector<std::string> kinds;
  std::vector<std::size_t> counts;
  for (const HolderLine& line : lines()) {
    if (which != Which::all && (line.what == "touch") != (which == Which::lasting)) continue;
    const auto at = std::ranges::find(kinds, line.what);
    if (at == kinds.end()) {
      kinds.push_back(line.what);
      counts.push_back(1);
    } else {
      ++counts[std::size_t(at - kinds.begin())];
    }
  }
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k] == "touch")
      parts.push_back(counted(counts[k], "atom in its way", "atoms in its way"));
    else
      parts.push_back(counted(counts[k], kinds[k], plural_of(kinds[k])));
  }
  return listed(parts);
}

std::string HeldWords::own_shape() const {
  if (held.taut)
    return "at the end of its reach: taut from " + start.atoms.label(held.taut->joints.back()) +
           " to " + start.atoms.label(held.taut->joints.front());
  const std::string ring = ring_text(start, joint);
  return ring.empty() ? "" : "part of " + ring;
}

/// Only where it says more than that two atoms are bonded.
std::string HeldWords::cluster() const {
  const ClusterList& found = shown.clusters;
  if (joint >= found.of_body.size() || found.of_body[joint] >= found.count(20)) return "";
  return "part of a rigid cluster of " +
         counted(found.sizes[found.of_body[joint]], "atom", "atoms");
}

bool HeldWords::has_removable() const {
  return std::ranges::any_of(held.holders,
                             [](const Holder& one) { return one.kind != Holder::Kind::pressed; });
}

/// What was cut in the trial and brought nothing is not said to hold.
std::string HeldWords::trial() const {
  if (!held.is_tried || !has_removable()) return "";
  if (held.frees())
    return " Without what can be cut it gets " + length_text(held.without) + " further, now " +
           length_text(held.as_it_is) + ".";
  return " Part of the pull goes through " + carried(Which::removable) +
         ", but cutting that does not free it.";
}

bool HeldWords::is_held() const { return held.is_pinned || held.as_it_is <= not_held; }

std::string HeldWords::said() const {
  const std::string name = start.atoms.label(joint);
  if (held.is_pinned) return name + " is pinned.";
  if (!is_held()) return name + " is not held: it moves on by " + length_text(held.as_it_is) + ".";
  std::string text = own_shape();
  if (const std::string rigid = cluster(); !rigid.empty())
    text += (text.empty() ? "" : "; ") + rigid;
  const bool frees_nothing = held.is_tried && has_removable() && !held.frees();
  const std::string by = carried(frees_nothing ? Which::lasting : Which::all);
  if (!by.empty()) text += (text.empty() ? "held by " : ", held by ") + by;
  if (text.empty())
    return name + " is held by its own bonds and angles: they drag the weight of " +
           number_text(std::round(1.0 / std::max(held.yields, 1e-6)), 3) + " atoms along." +
           trial();
  const bool is_alone = by.empty() && !held.taut;
  const std::string alone =
      is_alone ? " No contact or pin carries as much as a twentieth of the pull." : "";
  return name + " is " + text + "." + alone + trial();
}

}  // namespace pliant::play
