// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/body_plan.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "pliant/rigidity/unit_graph.hpp"

namespace pliant {
namespace {

constexpr std::uint32_t unset = ~std::uint32_t{0};

}  // namespace

UnitSet units_of_bodies(const Framework& framework) {
  UnitSet set = find_units(framework);
  if (!framework.drawn().empty()) set = std::move(merge_rigid_loops(framework, std::move(set)).set);
  std::vector<bool> is_in(framework.joint_count(), false);
  for (Joint joint : set.things()) is_in[joint] = true;
  for (Joint joint = 0; joint < framework.joint_count(); ++joint)
    if (!is_in[joint]) set.add(std::array<Joint, 1>{joint});
  return set;
}

class BodyPlanner {
 public:
  explicit BodyPlanner(const Framework& framework)
      : set_(units_of_bodies(framework)),
        graph_(connect_units(framework, set_)),
        from_(graph_.links.node_count(), unset),
        seen_(graph_.links.node_count(), 0),
        subtree_(graph_.links.node_count(), 0),
        body_of_(set_.size(), unset) {
    plan_.place_of_.assign(framework.joint_count(), unset);
  }

  BodyPlan run() {
    for (UnitNode unit = 0; unit < set_.size(); ++unit)
      if (body_of_[unit] == unset) add_tree(middle_of_longest_path(unit));
    return std::move(plan_);
  }

 private:
  void add_tree(UnitNode root) {
    const auto first = static_cast<std::uint32_t>(plan_.bodies_.size());
    plan_component(root);
    const auto last = static_cast<std::uint32_t>(plan_.bodies_.size());
    plan_.tree_of_.resize(last, static_cast<std::uint32_t>(plan_.trees_.size()));
    plan_.trees_.push_back({first, last});
  }

  /// Searches breadth first over units and connections; fills order_, and from_ with where each
  /// came from.
  void search(UnitNode root) {
    ++search_;
    order_.assign(1, root);
    from_[root] = unset;
    seen_[root] = search_;
    for (std::size_t k = 0; k < order_.size(); ++k)
      for (const Link& link : graph_.links.at(order_[k])) {
        if (seen_[link.node] == search_) continue;
        seen_[link.node] = search_;
        from_[link.node] = order_[k];
        order_.push_back(link.node);
      }
  }

  UnitNode last_unit() const {
    return *std::find_if(order_.rbegin(), order_.rend(),
                         [&](UnitNode node) { return graph_.is_unit(node); });
  }

  UnitNode middle_of_longest_path(UnitNode any) {
    search(any);
    search(last_unit());
    std::vector<UnitNode> path;
    for (UnitNode node = last_unit(); node != unset; node = from_[node])
      if (graph_.is_unit(node)) path.push_back(node);
    return path[path.size() / 2];
  }

  /// Depth first along the tree of the search, smaller branches first, so that joints that are
  /// near by bars get near numbers.
  void plan_component(UnitNode root) {
    search(root);
    count_subtrees();
    std::vector<UnitNode> waiting{root};
    std::vector<UnitNode> around;
    while (!waiting.empty()) {
      const UnitNode node = waiting.back();
      waiting.pop_back();
      if (graph_.is_unit(node)) add_body(node);
      around.clear();
      for (const Link& link : graph_.links.at(node))
        if (from_[link.node] == node) around.push_back(link.node);
      std::stable_sort(around.begin(), around.end(), [&](UnitNode one, UnitNode other) {
        return subtree_[one] > subtree_[other];
      });
      waiting.insert(waiting.end(), around.begin(), around.end());
    }
  }

  void count_subtrees() {
    for (UnitNode node : order_) subtree_[node] = 1;
    for (std::size_t k = order_.size(); k-- > 1;) subtree_[from_[order_[k]]] += subtree_[order_[k]];
  }

  void add_body(UnitNode unit) {
    PlanBody body;
    body.first_turn = static_cast<std::uint32_t>(plan_.turn_count_);
    UnitConnection entry{unset, unset};
    if (from_[unit] != unset) {
      entry = graph_.connection(from_[unit]);
      const std::uint32_t parent = body_of_[from_[from_[unit]]];
      body.parent = static_cast<std::int32_t>(parent);
      body.a = plan_.place_in(parent, entry.a);
      body.b = plan_.place_in(parent, entry.b);
    }
    const auto index = static_cast<std::uint32_t>(plan_.bodies_.size());
    body_of_[unit] = index;
    body.first = static_cast<Slot>(plan_.joint_at_.size());
    for (Joint joint : set_.at(unit))
      if (joint != entry.a && joint != entry.b) plan_.add_place(joint, index);
    body.last = static_cast<Slot>(plan_.joint_at_.size());
    plan_.turn_count_ += body.turns();
    plan_.bodies_.push_back(body);
  }

  UnitSet set_;
  UnitGraph graph_;
  BodyPlan plan_;
  std::vector<UnitNode> order_, from_;
  std::vector<std::uint32_t> seen_, subtree_;
  std::uint32_t search_ = 0;
  std::vector<std::uint32_t> body_of_;
};

void BodyPlan::add_place(Joint joint, std::uint32_t body) {
  const auto place = static_cast<Slot>(joint_at_.size());
  if (place_of_[joint] == no_place) {
    place_of_[joint] = place;
  } else {
    cuts_.push_back({place, place_of_[joint]});
  }
  joint_at_.push_back(joint);
  body_at_.push_back(body);
}

Slot BodyPlan::place_in(std::uint32_t body, Joint joint) const {
  for (const PlanBody* at = &bodies_[body];; at = &bodies_[std::size_t(at->parent)]) {
    for (Slot place = at->first; place < at->last; ++place)
      if (joint_at_[place] == joint) return place;
    if (at->parent < 0) return place_of_[joint];
  }
}

double BodyPlan::widest_gap(std::span<const Vec3> x) const {
  double widest = 0.0;
  for (const LoopCut& cut : cuts_) widest = std::max(widest, distance(x[cut.copy], x[cut.joint]));
  return widest;
}

std::optional<BodyPlan> BodyPlan::make(const Framework& framework) {
  if (framework.has_pinned_joints() || framework.is_planar()) return std::nullopt;
  return BodyPlanner(framework).run();
}

}  // namespace pliant
