// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "edits/joint_words.hpp"
#include "edits/pair_words.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "session.hpp"

namespace pliant::play {
namespace {

double apart(Joint a, Joint b) {
  const auto& x = session().state().positions;
  return distance(x[a], x[b]);
}

void check_joint(Joint joint) {
  const std::size_t count = session().document().framework.joint_count();
  if (joint >= count)
    throw OptionError("joint " + std::to_string(joint) + " of " + std::to_string(count) +
                      " does not exist");
}

std::vector<FrameworkEdit> turned(Joint a, Joint b) {
  const Document& document = session().document();
  std::vector<FrameworkEdit> cuts = bars_across(document, session().framework(), a, b);
  if (cuts.empty())
    throw OptionError("turn " + document.framework.label(Bar{a, b}) +
                      ": no planar group keeps it from turning");
  return cuts;
}

/// One row of the request.
std::vector<FrameworkEdit> edits_of(const Json& row) {
  if (!row.is_array() || row.size() < 3 || row.size() > 4 || !row[0].is_string())
    throw OptionError("edits: expected rows of a word and two joints, found " + row.dump());
  const std::string word = row[0].get<std::string>();
  const Joint a = joint_of(row[1]), b = joint_of(row[2]);
  check_joint(a);
  check_joint(b);
  if (word == "turn") return turned(a, b);
  if (word == "cut") return {{EditKind::cut, a, b}};
  if (word == "restore") return {{EditKind::restore, a, b}};
  if (word != "bar")
    throw OptionError("edits: expected cut, bar, restore or turn, found " + row[0].dump());
  if (row.size() == 4 && !row[3].is_number())
    throw OptionError("bar: expected a length above 0, found " + row[3].dump());
  return {{EditKind::bar, a, b, row.size() == 4 ? row[3].get<double>() : apart(a, b)}};
}

/// The last edit of each pair, in the order of these, without those that were restored.
std::vector<FrameworkEdit> in_force() {
  std::vector<FrameworkEdit> left;
  const auto& edited = session().walk().edited();
  if (!edited) return left;
  for (const FrameworkEdit& edit : edited->edits) {
    std::erase_if(left, [&](const FrameworkEdit& one) {
      return std::minmax(one.a, one.b) == std::minmax(edit.a, edit.b);
    });
    if (edit.kind != EditKind::restore) left.push_back(edit);
  }
  return left;
}

Json changes_told() {
  const Document& start = session().document();
  Json rows = Json::array();
  for (const FrameworkEdit& edit : in_force()) {
    const bool is_bar = edit.kind == EditKind::bar;
    const std::string pair = is_bar ? start.atoms.label(edit.a) + " – " + start.atoms.label(edit.b)
                                    : pair_text(start, start.framework, edit.a, edit.b);
    const std::string text =
        is_bar ? "bar " + pair + ", " + number_text(edit.length, 4) + " Å" : "cut: " + pair;
    rows.push_back({{"kind", name(edit.kind)}, {"a", edit.a}, {"b", edit.b}, {"text", text}});
  }
  return rows;
}

Reply told() {
  Reply reply = describe(session().shown(), session().state().positions);
  reply.fields["changes"] = changes_told();
  return reply;
}

}  // namespace

Reply edit(const Request& request) {
  std::vector<FrameworkEdit> edits;
  for (const Json& row : request.fields.at("edits"))
    for (const FrameworkEdit& one : edits_of(row)) edits.push_back(one);
  if (edits.empty()) throw OptionError("edits: expected rows of a word and two joints, found none");
  session().edit(edits);
  return told();
}

Reply edited(const Request&) { return told(); }

Reply pair(const Request& request) {
  const Joint a = joint_of(request.fields.at("a")), b = joint_of(request.fields.at("b"));
  check_joint(a);
  check_joint(b);
  const Document& start = session().document();
  const Framework& now = session().framework();
  const std::vector<FrameworkEdit> left = in_force();
  Reply reply;
  reply.fields = {{"joined", what_joins(start, now, a, b)},
                  {"text", pair_text(start, now, a, b)},
                  {"distance", apart(a, b)},
                  {"mayTurn", !bars_across(start, now, a, b).empty()},
                  {"isEdited", std::ranges::any_of(left, [&](const FrameworkEdit& one) {
                     return std::minmax(one.a, one.b) == std::minmax(a, b);
                   })}};
  return reply;
}

}  // namespace pliant::play
