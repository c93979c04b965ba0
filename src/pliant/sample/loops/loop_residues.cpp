// SPDX-License-Identifier: MIT
#include "pliant/sample/loops/loop_residues.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace pliant {
namespace {

constexpr double to_hydrogen = 1.3, to_oxygen = 1.6;  // Angstrom: longer than bonds

using Hinges = std::set<std::pair<Joint, Joint>>;

std::pair<Joint, Joint> sorted(Joint a, Joint b) { return {std::min(a, b), std::max(a, b)}; }

Hinges hinges_of(const BodyPlan& plan) {
  Hinges hinges;
  for (const PlanBody& body : plan.bodies())
    if (body.turns() == 1) hinges.insert(sorted(plan.joint_at()[body.a], plan.joint_at()[body.b]));
  return hinges;
}

bool contains(const std::vector<Joint>& joints, Joint joint) {
  return std::ranges::find(joints, joint) != joints.end();
}

class ResidueFinder {
 public:
  ResidueFinder(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start)
      : framework_(framework),
        atoms_(*framework.atoms()),
        start_(start),
        hinges_(hinges_of(plan)) {}

  std::vector<LoopResidue> find() {
    for (Joint first = 0, last = 0; first < atoms_.size(); first = last) {
      while (last < atoms_.size() && atoms_.residue_of[last] == atoms_.residue_of[first]) ++last;
      add(first, last);
    }
    for (std::size_t k = 0; k + 1 < found_.size(); ++k) link(found_[k], found_[k + 1]);
    for (LoopResidue& one : found_) measure(one);
    of_residue_.assign(atoms_.residues.size(), nullptr);
    for (LoopResidue& one : found_) of_residue_[one.residue] = &one;
    for (const Bar& bar : framework_.bars()) hold(bar);
    count_contacts();
    return std::move(found_);
  }

 private:
  bool turns(Joint a, Joint b) const { return hinges_.contains(sorted(a, b)); }

  Joint named(std::string_view name, Joint first, Joint last) const {
    while (first < last && atoms_.names[first] != name) ++first;
    return first;
  }

  /// The residue of joints [first, last), if it is one of a protein.
  void add(Joint first, Joint last) {
    LoopResidue one;
    one.residue = atoms_.residue_of[first];
    one.n = named("N", first, last);
    one.ca = named("CA", first, last);
    one.c = named("C", first, last);
    if (one.n == last || one.ca == last || one.c == last) return;
    for (Joint joint = first; joint < last; ++joint)
      one.parts[part_of(one, joint)].push_back(joint);
    one.has_phi = turns(one.n, one.ca);
    one.has_psi = turns(one.ca, one.c);
    const std::string& name = atoms_.residues[one.residue].name;
    if (name == "GLY") one.kind = LoopResidueKind::glycine;
    if (name == "PRO") one.kind = LoopResidueKind::proline;
    found_.push_back(std::move(one));
  }

  std::size_t part_of(const LoopResidue& in, Joint joint) const {
    constexpr std::uint8_t hydrogen = 1, oxygen = 8;
    const auto is_at = [&](Joint other, double reach) {
      return distance(start_[joint], start_[other]) < reach;
    };
    const std::uint8_t element = atoms_.elements[joint];
    if (joint == in.n || joint == in.ca || (element == hydrogen && is_at(in.n, to_hydrogen)))
      return 0;
    return element == oxygen && is_at(in.c, to_oxygen) ? 2 : 1;
  }

  void link(LoopResidue& one, LoopResidue& next) const {
    const auto at_c = framework_.neighbours(one.c);
    if (std::ranges::find(at_c, next.n, &Incidence::joint) == at_c.end()) return;
    one.is_linked_behind = next.is_linked_before = true;
    one.behind = next.n;
    next.before = one.c;
    if (turns(one.c, next.n)) one.is_held = next.is_held = true;  // no peptide group that is planar
    if (next.kind == LoopResidueKind::proline && one.kind == LoopResidueKind::general)
      one.kind = LoopResidueKind::before_proline;
  }

  void measure(LoopResidue& one) const {
    if (!one.is_linked_before || !one.is_linked_behind) return;
    const Vec3 n = start_[one.n], ca = start_[one.ca], c = start_[one.c];
    one.start = {torsion_angle(start_[one.before], n, ca, c),
                 torsion_angle(n, ca, c, start_[one.behind])};
    one.reach = std::max(1.0, loop_reach(one.kind, one.start));
  }

  /// Bars between residues other than those of a peptide group hold both.
  void hold(const Bar& bar) const {
    LoopResidue* a = of_residue_[atoms_.residue_of[bar.a]];
    LoopResidue* b = of_residue_[atoms_.residue_of[bar.b]];
    if (a == b || is_in_peptide(a, b, bar.a, bar.b) || is_in_peptide(b, a, bar.b, bar.a)) return;
    for (LoopResidue* one : {a, b})
      if (one != nullptr) one->is_held = true;
  }

  static bool is_in_peptide(const LoopResidue* one, const LoopResidue* next, Joint of_one,
                            Joint of_next) {
    if (one == nullptr || next == nullptr || one + 1 != next || !one->is_linked_behind)
      return false;
    const bool is_before = of_one == one->ca || of_one == one->c || contains(one->parts[2], of_one);
    return is_before && contains(next->parts[0], of_next);
  }

  void count_contacts() const {
    std::set<std::uint32_t> seen;
    for (const Limit& limit : framework_.limits()) {
      if (limit.group != no_limit_group && !seen.insert(limit.group).second) continue;
      for (const Joint joint : {limit.a, limit.b}) {
        LoopResidue* one = of_residue_[atoms_.residue_of[joint]];
        if (one == nullptr) continue;
        one->contacts += 0.5;
        one->is_held = one->is_held || limit.kind == LimitKind::metal;
      }
    }
  }

  const Framework& framework_;
  const AtomTable& atoms_;
  std::span<const Vec3> start_;
  Hinges hinges_;
  std::vector<LoopResidue> found_;
  std::vector<LoopResidue*> of_residue_;  ///< (residues of the table) null: no protein
};

}  // namespace

std::vector<LoopResidue> loop_residues(const Framework& framework, const BodyPlan& plan,
                                       std::span<const Vec3> start) {
  return ResidueFinder(framework, plan, start).find();
}

}  // namespace pliant
