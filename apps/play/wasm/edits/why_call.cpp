// SPDX-License-Identifier: MIT
#include "calls.hpp"

#include <span>
#include <vector>

#include "edits/joint_words.hpp"
#include "edits/why_words.hpp"
#include "pliant/base/error.hpp"
#include "session.hpp"

namespace pliant::play {
namespace {

HandPull hand_of(const Json& fields) {
  HandPull hand;
  hand.joint = joint_of(fields.at("joint"));
  const std::size_t count = session().framework().joint_count();
  if (hand.joint >= count)
    throw OptionError("joint " + std::to_string(hand.joint) + " of " + std::to_string(count) +
                      " does not exist");
  const Json& target = fields.at("target");
  if (!target.is_array() || target.size() != 3)
    throw OptionError("target: expected x, y, z, found " + target.dump());
  hand.target = {target[0], target[1], target[2]};
  hand.share = fields.value("share", hand.share);
  hand.furthest = fields.value("furthest", hand.furthest);
  if (!is_finite(hand.target) || !(hand.share > 0.0) || !(hand.furthest > 0.0))
    throw OptionError("why: expected a finite target, and share and furthest above 0");
  return hand;
}

Json rows_of(const std::vector<HolderLine>& lines) {
  Json rows = Json::array();
  for (const HolderLine& line : lines)
    rows.push_back({{"text", line.text},
                    {"what", line.what},
                    {"a", line.a},
                    {"b", line.b},
                    {"load", line.load},
                    {"cut", line.may_be_cut}});
  return rows;
}

}  // namespace

Reply why(const Request& request) {
  const HandPull hand = hand_of(request.fields);
  const HeldPull held = why_held(session().walk(), hand);
  const Document shown = session().shown();
  const HeldWords words{session().document(), shown, session().framework(), hand.joint, held};
  Reply reply;
  reply.fields = {{"said", words.said()},      {"lines", rows_of(words.lines())},
                  {"isHeld", words.is_held()}, {"yields", held.yields},
                  {"tried", held.is_tried},    {"frees", held.frees()},
                  {"asItIs", held.as_it_is},   {"without", held.without}};
  if (held.taut) reply.fields["taut"] = {{"joints", held.taut->joints}};
  const std::vector<std::int32_t> loaded(held.loaded.begin(), held.loaded.end());
  reply.add("loaded", std::span<const std::int32_t>(loaded));
  return reply;
}

}  // namespace pliant::play
