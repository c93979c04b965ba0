// SPDX-License-Identifier: MIT
#include "pliant/order/check_ordering.hpp"

#include <numeric>

namespace pliant {
namespace {

/// Union-find with path halving.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Joint{0});
  }
  bool join(Joint a, Joint b) {
    a = top(a);
    b = top(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  Joint top(Joint joint) {
    while (parent_[joint] != joint) joint = parent_[joint] = parent_[parent_[joint]];
    return joint;
  }
  std::vector<Joint> parent_;
};

}  // namespace

std::string check_ordering(const Framework& framework, const Ordering& ordering,
                           const OrderingPromise& promise) {
  std::vector<bool> visited(framework.bar_count(), false);
  JoinedSets joined(framework.joint_count());
  for (const OrderedBar& visit : ordering) {
    if (visit.bar >= framework.bar_count()) return "bar " + std::to_string(visit.bar) + " unknown";
    const Bar bar = framework.bars()[visit.bar];
    if (visited[visit.bar]) return "bar " + framework.label(bar) + " appears twice";
    visited[visit.bar] = true;
    if (visit.near != bar.a && visit.near != bar.b)
      return "bar " + framework.label(bar) + " has a near joint that is not its end";
    if (promise.tree_bars && visit.is_tree && !joined.join(bar.a, bar.b))
      return "tree bar " + framework.label(bar) + " closes a cycle";
  }
  if (!promise.all_bars) return "";
  for (std::size_t k = 0; k < visited.size(); ++k)
    if (!visited[k]) return "bar " + framework.label(framework.bars()[k]) + " is missing";
  return "";
}

}  // namespace pliant
