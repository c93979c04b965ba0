// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_plan.hpp"

#include <algorithm>
#include <optional>

#include "pliant/conformers/torsions/bond_turn_kinds.hpp"
#include "pliant/conformers/torsions/small_sterics.hpp"

namespace pliant {
namespace {

class LoopPlanner {
 public:
  LoopPlanner(const Framework& framework, const BodyPlan& plan, const BondChemistry& chemistry)
      : framework_(framework), plan_(plan), chemistry_(chemistry) {}

  /// False if one of them is no hinge.
  bool add_hinges(const std::vector<bool>& is_in_loop) {
    const auto bodies = plan_.bodies();
    for (std::uint32_t k = 0; k < bodies.size(); ++k) {
      if (!is_in_loop[k]) continue;
      if (bodies[k].turns() != 1) return false;
      out_.hinges.push_back({bodies[k].a, bodies[k].b, bodies[k].first, end_of_branch(k)});
    }
    return true;
  }

  void add_torsions() {
    for (Joint a = 0; a < framework_.joint_count(); ++a)
      for (const Link& bond : chemistry_.bonds_at(a))
        if (bond.node > a && chemistry_.is_in_ring(a) && chemistry_.is_in_ring(bond.node))
          add_torsion(a, bond.node);
  }

  void add_pairs(const std::vector<bool>& is_rotor) {
    const std::vector<std::uint32_t> part = parts_between(is_rotor);
    const SmallSterics sterics(framework_);
    for (const NeighbourPair& pair : sterics.pairs()) {
      const Slot i = plan_.place_of(pair.a), j = plan_.place_of(pair.b);
      if (part[plan_.body_at()[i]] != part[plan_.body_at()[j]]) continue;
      const bool is_moved =
          std::any_of(out_.hinges.begin(), out_.hinges.end(),
                      [&](const LoopHinge& at) { return at.turns(i) != at.turns(j); });
      if (is_moved) out_.pairs.push_back({i, j, pair.least, bond_between(pair.a, pair.b)});
    }
  }

  LoopPlan take() { return std::move(out_); }

 private:
  /// The plan goes depth first: what hangs on a body follows it.
  Slot end_of_branch(std::uint32_t body) const {
    const auto bodies = plan_.bodies();
    std::uint32_t k = body + 1;
    while (k < bodies.size() && bodies[k].parent >= std::int64_t{body}) ++k;
    return bodies[k - 1].last;
  }

  /// Where a unit has a joint.
  std::optional<Slot> place_in(const PlanBody& body, Joint joint) const {
    const auto joint_at = plan_.joint_at();
    for (Slot place = body.first; place < body.last; ++place)
      if (joint_at[place] == joint) return place;
    if (body.parent < 0) return std::nullopt;
    for (Slot place : {body.a, body.b})
      if (joint_at[place] == joint) return place;
    return std::nullopt;
  }

  const PlanBody* body_with(std::array<Joint, 3> joints) const {
    for (const PlanBody& body : plan_.bodies())
      if (std::all_of(joints.begin(), joints.end(),
                      [&](Joint joint) { return place_in(body, joint).has_value(); }))
        return &body;
    return nullptr;
  }

  /// Adds none where the bond is in one rigid unit with what is on both sides.
  void add_torsion(Joint a, Joint b) {
    const Joint before = chemistry_.reference(a, b), after = chemistry_.reference(b, a);
    const PlanBody* one = body_with({before, a, b});
    const PlanBody* other = body_with({a, b, after});
    if (one == nullptr || other == nullptr || one == other || before == a || after == b) return;
    LoopTorsion found{{*place_in(*one, before), *place_in(*one, a), *place_in(*other, b),
                       *place_in(*other, after)},
                      turn_in_loop(chemistry_, a, b),
                      -1,
                      true};
    for (std::size_t k = 0; k < out_.hinges.size(); ++k) {
      const LoopHinge& hinge = out_.hinges[k];
      if (!is_of(hinge, a, b) || hinge.turns(found.at[0]) == hinge.turns(found.at[3])) continue;
      found.hinge = std::int64_t(k);
      found.is_forward = hinge.turns(found.at[3]);
    }
    out_.torsions.push_back(found);
  }

  bool is_of(const LoopHinge& hinge, Joint a, Joint b) const {
    return std::minmax(plan_.joint_at()[hinge.a], plan_.joint_at()[hinge.b]) == std::minmax(a, b);
  }

  HydrogenBond bond_between(Joint a, Joint b) const {
    const bool is_one = chemistry_.donates(a) && chemistry_.accepts(b);
    if (!is_one && !(chemistry_.donates(b) && chemistry_.accepts(a))) return HydrogenBond::none;
    return chemistry_.is_hydrogen(a) || chemistry_.is_hydrogen(b) ? HydrogenBond::to_hydrogen
                                                                  : HydrogenBond::beside_it;
  }

  /// Bodies that hang together by other hinges than rotors have the same number.
  std::vector<std::uint32_t> parts_between(const std::vector<bool>& is_rotor) const {
    const auto bodies = plan_.bodies();
    std::vector<std::uint32_t> part(bodies.size());
    for (std::uint32_t k = 0; k < bodies.size(); ++k)
      part[k] = bodies[k].parent < 0 || is_rotor[k] ? k : part[std::size_t(bodies[k].parent)];
    return part;
  }

  const Framework& framework_;
  const BodyPlan& plan_;
  const BondChemistry& chemistry_;
  LoopPlan out_;
};

}  // namespace

LoopPlan plan_loops(const Framework& framework, const BodyPlan& plan,
                    const BondChemistry& chemistry, const std::vector<bool>& is_in_loop,
                    const std::vector<bool>& is_rotor) {
  LoopPlanner planner(framework, plan, chemistry);
  if (framework.atoms() == nullptr || !planner.add_hinges(is_in_loop)) return {};
  planner.add_torsions();
  planner.add_pairs(is_rotor);
  return planner.take();
}

}  // namespace pliant
