// SPDX-License-Identifier: MIT
#include "steps/order_calls.hpp"

#include "pliant/base/error.hpp"
#include "pliant/order/ordering_file.hpp"
#include "session.hpp"
#include "settings.hpp"

namespace pliant::play {
namespace {

void add_visits(Reply& reply, const Ordering& ordering) {
  std::vector<std::int32_t> visits;
  for (const OrderedBar& visit : ordering) {
    const Bar bar = session().framework().bars()[visit.bar];
    const Joint far = visit.near == bar.a ? bar.b : bar.a;
    for (const std::uint32_t number : {visit.bar, visit.near, far})
      visits.push_back(static_cast<std::int32_t>(number));
    visits.push_back(visit.is_tree ? 1 : 0);
  }
  reply.add("visits", std::span<const std::int32_t>(visits));
}

}  // namespace

Reply ordering_file(const Request& request) {
  const std::string name = request.fields.value("name", "ordering file");
  auto ordering = std::make_shared<const Ordering>(
      parse_ordering_file({name, request.bytes}, session().document().framework));
  session().order(ordering);
  Reply reply;
  add_visits(reply, *ordering);
  reply.fields["settings"] = settings_of(session().options());
  return reply;
}

Reply ordering(const Request& request) {
  const Framework& framework = session().framework();
  const auto root = request.fields.value("root", Joint{0});
  if (root >= framework.joint_count())
    throw OptionError("ordering: joint " + std::to_string(root) + " does not exist");
  const OrderingEntry& entry = find_ordering(request.fields.value("technique", "bfs_cycle"));
  const RunOptions& options = session().options();
  OrderScratch scratch;
  Ordering found;
  RandomKey key;
  key.seed = options.resolve.seed;
  const bool is_given = entry.name == "input";
  entry.order({framework, root, 0, key, session().state().positions, nullptr,
               is_given ? options.technique.ordering.get() : nullptr},
              scratch, found);
  Reply reply;
  add_visits(reply, found);
  if (!entry.forests_only) reply.fields["text"] = write_ordering_file(found, framework);
  return reply;
}

}  // namespace pliant::play
