// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/cut_closing.hpp"

#include <algorithm>

#include "pliant/base/math/dense_solve.hpp"

namespace pliant {
namespace {

constexpr double redundant = 1e-9;
constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};

double of_axis(Vec3 x, std::size_t axis) { return axis == 0 ? x.x : (axis == 1 ? x.y : x.z); }

}  // namespace

CutClosing::CutClosing(const BodyPlan& plan, const WorkingTrees& working)
    : plan_(plan), working_(working) {}

void CutClosing::correct(ArticulatedPass& pass, std::span<const Vec3> x, BodyMotions& motions) {
  const auto tree_of = [&](const LoopCut& cut) { return plan_.tree_of(plan_.body_at()[cut.copy]); };
  cuts_.clear();
  for (const LoopCut& cut : plan_.cuts())
    if (working_.holds(tree_of(cut))) cuts_.push_back(cut);
  if (cuts_.empty()) return;
  std::ranges::stable_sort(cuts_, {}, tree_of);
  forces_.assign(motions.twists.size(), Twist{});
  bool closes = false;
  for (auto first = cuts_.begin(); first != cuts_.end();) {
    const auto last = std::ranges::upper_bound(first, cuts_.end(), tree_of(*first), {}, tree_of);
    closes |= close_tree(pass, x, motions, {first, last});
    first = last;
  }
  if (closes) apply(pass, motions);
}

/// Adds the forces that close the cuts of one tree. False: there are none.
bool CutClosing::close_tree(const ArticulatedPass& pass, std::span<const Vec3> x,
                            const BodyMotions& motions, std::span<const LoopCut> cuts) {
  const BodyTree& tree = plan_.trees()[plan_.tree_of(plan_.body_at()[cuts.front().copy])];
  find_ways(tree, cuts);
  start_forces(x, cuts);
  set_gaps(x, motions, cuts);
  products_.assign(factors_.size() * factors_.size(), 0.0);
  for (std::uint32_t body = tree.last; body-- > tree.first;)
    if (const auto passing = ways_.at(body - tree.first); !passing.empty())
      go_through(pass, body, passing);
  regularize();
  if (!solve_positive(products_, factors_, 0.0)) return false;
  add_closing_forces(x, cuts);
  return true;
}

/// Both places of a cut go inward to where their ways meet, and on to the root. Parents come first,
/// so that of two bodies the later one goes.
void CutClosing::find_ways(const BodyTree& tree, std::span<const LoopCut> cuts) {
  const auto bodies = plan_.bodies();
  const auto above = [&](std::uint32_t body) {
    return static_cast<std::uint32_t>(bodies[body].parent);
  };
  ways_ = Grouped<Passing>(tree.last - tree.first, [&](const auto& put) {
    for (std::uint32_t cut = 0; cut < cuts.size(); ++cut) {
      std::uint32_t one = plan_.body_at()[cuts[cut].copy], other = plan_.body_at()[cuts[cut].joint];
      while (one != other) {
        const From from = one > other ? From::copy : From::joint;
        std::uint32_t& later = from == From::copy ? one : other;
        put(later - tree.first, Passing{cut, from});
        later = above(later);
      }
      put(one - tree.first, Passing{cut, From::both});
      while (bodies[one].parent >= 0) {
        one = above(one);
        put(one - tree.first, Passing{cut, From::copy});
      }
    }
  });
}

/// Unit forces along the axes on one place of each cut, and reversed on the other.
void CutClosing::start_forces(std::span<const Vec3> x, std::span<const LoopCut> cuts) {
  of_copies_.resize(cuts.size());
  of_joints_.resize(cuts.size());
  for (std::size_t cut = 0; cut < cuts.size(); ++cut)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [copy, joint] = cuts[cut];
      of_copies_[cut][k] = twist_of(cross(x[copy], axes[k]), axes[k]);
      of_joints_[cut][k] = twist_of(cross(axes[k], x[joint]), -1.0 * axes[k]);
    }
}

/// Takes forces through the turns of a body, and adds their products to those of G H^-1 G^T.
void CutClosing::go_through(const ArticulatedPass& pass, std::uint32_t body,
                            std::span<const Passing> passing) {
  for (const auto& [cut, from] : passing)
    for (std::size_t k = 0; k < 3 && from == From::both; ++k)
      froda::add_scaled(1.0, of_joints_[cut][k], of_copies_[cut][k]);
  const PlanBody& of = plan_.bodies()[body];
  if (of.parent < 0) return add_root(pass, body, passing);
  along_.resize(of.turns() * passing.size());
  for (std::size_t k = 0; k < passing.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      pass.carry(body, forces_of(passing[k])[axis], [&](std::uint32_t turn, double force) {
        along_[(turn - of.first_turn) * passing.size() + k][axis] = force;
      });
  for (std::uint32_t turn = of.turns(); turn-- > 0;)
    add_turn(pass.turns()[of.first_turn + turn].inverse, passing,
             along_.data() + turn * passing.size());
}

/// The lower triangle alone: those that pass are sorted by cut.
void CutClosing::add_turn(double inverse, std::span<const Passing> passing, const Three* along) {
  const std::size_t count = factors_.size();
  for (std::size_t one = 0; one < passing.size(); ++one)
    for (std::size_t i = 0; i < 3; ++i) {
      const double scaled = inverse * along[one][i];
      double* const row = products_.data() + (3 * passing[one].cut + i) * count;
      for (std::size_t other = 0; other <= one; ++other)
        for (std::size_t j = 0; j < 3; ++j)
          row[3 * passing[other].cut + j] += scaled * along[other][j];
    }
}

void CutClosing::add_root(const ArticulatedPass& pass, std::uint32_t root,
                          std::span<const Passing> passing) {
  const std::size_t count = factors_.size();
  for (const Passing& other : passing)
    for (std::size_t j = 0; j < 3; ++j) {
      const Twist answer = pass.answer_of_root(root, of_copies_[other.cut][j]);
      for (std::size_t one = other.cut; one < of_copies_.size(); ++one)
        for (std::size_t i = 0; i < 3; ++i)
          products_[(3 * one + i) * count + 3 * other.cut + j] +=
              froda::dot(of_copies_[one][i], answer);
    }
}

/// Two joints of one cut keep their distance, so that one of their six rows says nothing new.
void CutClosing::regularize() {
  const std::size_t count = factors_.size();
  double trace = 0.0;
  for (std::size_t k = 0; k < count; ++k) trace += products_[k * count + k];
  for (std::size_t k = 0; k < count; ++k)
    products_[k * count + k] += redundant * trace / double(count);
}

/// How far from closed the motions leave each cut, to first order.
void CutClosing::set_gaps(std::span<const Vec3> x, const BodyMotions& motions,
                          std::span<const LoopCut> cuts) {
  const auto body_at = plan_.body_at();
  factors_.clear();
  for (const auto [copy, joint] : cuts) {
    const Vec3 left = (x[copy] + froda::velocity(motions.twists[body_at[copy]], x[copy])) -
                      (x[joint] + froda::velocity(motions.twists[body_at[joint]], x[joint]));
    for (std::size_t k = 0; k < 3; ++k) factors_.push_back(of_axis(left, k));
  }
}

void CutClosing::add_closing_forces(std::span<const Vec3> x, std::span<const LoopCut> cuts) {
  const auto body_at = plan_.body_at();
  for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
    const auto [copy, joint] = cuts[cut];
    const Vec3 force{factors_[3 * cut], factors_[3 * cut + 1], factors_[3 * cut + 2]};
    froda::add_scaled(1.0, twist_of(cross(x[copy], force), force), forces_[body_at[copy]]);
    froda::add_scaled(-1.0, twist_of(cross(x[joint], force), force), forces_[body_at[joint]]);
  }
}

/// Takes off what the forces that close the cuts move.
void CutClosing::apply(ArticulatedPass& pass, BodyMotions& motions) {
  correction_ = motions;
  pass.push_inward(forces_);
  pass.go_outward(forces_, correction_);
  for (std::size_t k = 0; k < motions.twists.size(); ++k)
    froda::add_scaled(-1.0, correction_.twists[k], motions.twists[k]);
  for (std::size_t t = 0; t < motions.angles.size(); ++t)
    motions.angles[t] -= correction_.angles[t];
}

}  // namespace pliant
