// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/cut_closing.hpp"

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
  choose_cuts();
  if (cuts_.empty()) return;
  shares_.clear();
  first_.assign(1, 0);
  for (std::size_t cut = 0; cut < roots_.size(); ++cut) climb(pass, x, cut);
  multiply(pass);
  set_gaps(x, motions);
  if (solve_positive(products_, factors_, 0.0)) apply(pass, x, motions);
}

void CutClosing::choose_cuts() {
  cuts_.clear();
  for (const LoopCut& cut : plan_.cuts())
    if (working_.holds(plan_.tree_of(plan_.body_at()[cut.copy]))) cuts_.push_back(cut);
  roots_.resize(cuts_.size());
}

/// Climbs from both places of a cut to where their ways meet, and on to the root. Parents come
/// first, so that of two bodies the later one goes.
void CutClosing::climb(const ArticulatedPass& pass, std::span<const Vec3> x, std::size_t cut) {
  const auto [copy, joint] = cuts_[cut];
  const auto bodies = plan_.bodies();
  std::array<Twist, 3> forces, others;
  for (std::size_t k = 0; k < 3; ++k) {
    forces[k] = twist_of(cross(x[copy], axes[k]), axes[k]);
    others[k] = twist_of(cross(axes[k], x[joint]), -1.0 * axes[k]);
  }
  std::uint32_t one = plan_.body_at()[copy], other = plan_.body_at()[joint];
  while (one != other) {
    std::uint32_t& later = one > other ? one : other;
    take_turns(pass, later, one > other ? forces : others);
    later = static_cast<std::uint32_t>(bodies[later].parent);
  }
  for (std::size_t k = 0; k < 3; ++k) froda::add_scaled(1.0, others[k], forces[k]);
  for (; bodies[one].parent >= 0; one = static_cast<std::uint32_t>(bodies[one].parent))
    take_turns(pass, one, forces);
  Root& root = roots_[cut];
  root.body = one;
  root.forces = forces;
  for (std::size_t k = 0; k < 3; ++k) root.answers[k] = pass.answer_of_root(one, forces[k]);
  first_.push_back(shares_.size());
}

void CutClosing::take_turns(const ArticulatedPass& pass, std::uint32_t body,
                            std::array<Twist, 3>& forces) {
  const std::uint32_t turns = plan_.bodies()[body].turns();
  const std::size_t first = shares_.size();
  shares_.resize(first + turns);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t at = first;
    pass.carry(body, forces[axis], [&](std::uint32_t turn, double force) {
      shares_[at].turn = turn;
      shares_[at++].forces[axis] = force;
    });
  }
}

/// G H^-1 G^T, its lower triangle.
void CutClosing::multiply(const ArticulatedPass& pass) {
  const std::size_t count = 3 * roots_.size();
  products_.assign(count * count, 0.0);
  for (std::size_t one = 0; one < roots_.size(); ++one)
    for (std::size_t other = 0; other <= one; ++other) {
      const auto entries = product(one, other, pass.turns());
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          products_[(3 * one + i) * count + 3 * other + j] = entries[i][j];
    }
  double trace = 0.0;
  for (std::size_t k = 0; k < count; ++k) trace += products_[k * count + k];
  // Two joints of one cut keep their distance, so that one of their six rows says nothing new.
  for (std::size_t k = 0; k < count; ++k)
    products_[k * count + k] += redundant * trace / double(count);
}

/// Sums over the turns that both go through, and the root.
std::array<CutClosing::Three, 3> CutClosing::product(
    std::size_t one, std::size_t other, std::span<const ArticulatedPass::Turn> turns) const {
  std::array<Three, 3> sums{};
  if (roots_[one].body != roots_[other].body) return sums;
  const Share *a = shares_.data() + first_[one], *b = shares_.data() + first_[other];
  const Share *a_end = shares_.data() + first_[one + 1],
              *b_end = shares_.data() + first_[other + 1];
  while (a != a_end && b != b_end) {
    if (a->turn != b->turn) {
      ++(a->turn > b->turn ? a : b);
      continue;
    }
    const double inverse = turns[a->turn].inverse;
    for (std::size_t i = 0; i < 3; ++i) {
      const double scaled = inverse * a->forces[i];
      for (std::size_t j = 0; j < 3; ++j) sums[i][j] += scaled * b->forces[j];
    }
    ++a;
    ++b;
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      sums[i][j] += froda::dot(roots_[one].forces[i], roots_[other].answers[j]);
  return sums;
}

/// How far from closed the motions leave each cut, to first order.
void CutClosing::set_gaps(std::span<const Vec3> x, const BodyMotions& motions) {
  const auto body_at = plan_.body_at();
  factors_.clear();
  for (const auto [copy, joint] : cuts_) {
    const Vec3 left = (x[copy] + froda::velocity(motions.twists[body_at[copy]], x[copy])) -
                      (x[joint] + froda::velocity(motions.twists[body_at[joint]], x[joint]));
    for (std::size_t k = 0; k < 3; ++k) factors_.push_back(of_axis(left, k));
  }
}

/// Takes off what the forces that close the cuts move.
void CutClosing::apply(ArticulatedPass& pass, std::span<const Vec3> x, BodyMotions& motions) {
  const auto body_at = plan_.body_at();
  forces_.assign(motions.twists.size(), Twist{});
  for (std::size_t cut = 0; cut < roots_.size(); ++cut) {
    const auto [copy, joint] = cuts_[cut];
    const Vec3 force{factors_[3 * cut], factors_[3 * cut + 1], factors_[3 * cut + 2]};
    froda::add_scaled(1.0, twist_of(cross(x[copy], force), force), forces_[body_at[copy]]);
    froda::add_scaled(-1.0, twist_of(cross(x[joint], force), force), forces_[body_at[joint]]);
  }
  correction_ = motions;
  pass.push_inward(forces_);
  pass.go_outward(forces_, correction_);
  for (std::size_t k = 0; k < motions.twists.size(); ++k)
    froda::add_scaled(-1.0, correction_.twists[k], motions.twists[k]);
  for (std::size_t t = 0; t < motions.angles.size(); ++t)
    motions.angles[t] -= correction_.angles[t];
}

}  // namespace pliant
