// SPDX-License-Identifier: MIT
#include "edits/pair_words.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace pliant::play {
namespace {

bool are_bonded(const Document& document, Joint a, Joint b) {
  const auto [low, high] = std::minmax(a, b);
  return std::ranges::any_of(document.bonds,
                             [&](const Bond& bond) { return bond.a == low && bond.b == high; });
}

std::vector<Joint> bonded_to(const Document& document, Joint joint) {
  std::vector<Joint> found;
  for (const Bond& bond : document.bonds)
    if (bond.a == joint || bond.b == joint) found.push_back(bond.a == joint ? bond.b : bond.a);
  return found;
}

bool share_a_neighbour(const Document& document, Joint a, Joint b) {
  const std::vector<Joint> around = bonded_to(document, a);
  return std::ranges::any_of(around, [&](Joint c) { return are_bonded(document, c, b); });
}

bool has_bar(const Framework& framework, Joint a, Joint b) {
  return std::ranges::any_of(framework.neighbours(a),
                             [&](const Incidence& at) { return at.joint == b; });
}

std::string joined_by_limit(const Document& document, const Framework& now, Joint a, Joint b) {
  for (const LimitIndex k : now.limits_at(a)) {
    const Limit& limit = now.limits()[k];
    if (limit.a != b && limit.b != b) continue;
    if (limit.group < document.contacts.size())
      return std::string(entry(document.contacts[limit.group].kind).singular);
    return "limit";
  }
  return "";
}

}  // namespace

std::string what_joins(const Document& document, const Framework& now, Joint a, Joint b) {
  if (!has_bar(now, a, b)) return joined_by_limit(document, now, a, b);
  if (document.kind == "graph" || !has_bar(document.framework, a, b)) return "bar";
  if (are_bonded(document, a, b)) return "bond";
  return share_a_neighbour(document, a, b) ? "angle" : "planar group";
}

std::vector<FrameworkEdit> bars_across(const Document& document, const Framework& now, Joint a,
                                       Joint b) {
  std::vector<FrameworkEdit> cuts;
  if (document.kind == "graph" || !are_bonded(document, a, b)) return cuts;
  for (const Joint one : bonded_to(document, a))
    for (const Joint other : bonded_to(document, b)) {
      const bool is_across = one != b && other != a && one != other && has_bar(now, one, other);
      if (is_across && what_joins(document, now, one, other) == "planar group")
        cuts.push_back({EditKind::cut, one, other});
    }
  return cuts;
}

std::string pair_text(const Document& document, const Framework& now, Joint a, Joint b) {
  const std::string what = what_joins(document, now, a, b);
  return (what.empty() ? "" : what + " ") + document.atoms.label(a) + " – " +
         document.atoms.label(b);
}

}  // namespace pliant::play
