// SPDX-License-Identifier: MIT
#include "pliant/sample/loops/loop_draw.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace pliant {
namespace {

constexpr double turn_round = 2.0 * std::numbers::pi;
constexpr double least_share = 0.4;  // of residues redrawn
constexpr double inside = 0.9;       // of the reach: turns that close a loop may lead out again

double around(double angle) { return angle - turn_round * std::floor(angle / turn_round + 0.5); }

}  // namespace

std::vector<LoopAxis> LoopTurns::axes() const {
  std::vector<LoopAxis> out;
  const auto add = [&](Joint a, Joint b) {
    const Vec3 bond = start_[b] - start_[a];
    out.push_back({start_[b], (1.0 / norm(bond)) * bond});
  };
  for (const LoopResidue& one : loop_) {
    if (one.has_phi) add(one.n, one.ca);
    if (one.has_psi) add(one.ca, one.c);
  }
  return out;
}

std::vector<double> LoopTurns::draw(double share, RandomSequence& draws) const {
  std::vector<double> turns;
  for (const LoopResidue& one : loop_) {
    PhiPsi to = one.start;
    if (draws.uniform() < share) to = draw_phi_psi(one.kind, draws);
    if (one.has_phi) turns.push_back(around(to.phi - one.start.phi));
    if (one.has_psi) turns.push_back(around(to.psi - one.start.psi));
  }
  return turns;
}

std::vector<PhiPsi> LoopTurns::torsions(std::span<const double> turns) const {
  std::vector<PhiPsi> out;
  std::size_t next = 0;
  for (const LoopResidue& one : loop_) {
    PhiPsi at = one.start;
    if (one.has_phi) at.phi = around(at.phi + turns[next++]);
    if (one.has_psi) at.psi = around(at.psi + turns[next++]);
    out.push_back(at);
  }
  return out;
}

void LoopTurns::add_wishes(std::span<const double> turns, std::span<double> wishes) const {
  const std::vector<PhiPsi> now = torsions(turns);
  std::size_t next = 0;
  for (std::size_t k = 0; k < loop_.size(); ++k) {
    const BackboneTurn back = loop_turn(loop_[k].kind, now[k], inside * loop_[k].reach);
    if (loop_[k].has_phi) wishes[next++] += back.phi;
    if (loop_[k].has_psi) wishes[next++] += back.psi;
  }
}

bool LoopTurns::are_allowed(std::span<const double> turns) const {
  constexpr double rounding = 1e-9;
  const std::vector<PhiPsi> now = torsions(turns);
  for (std::size_t k = 0; k < loop_.size(); ++k)
    if (!(loop_reach(loop_[k].kind, now[k]) <= loop_[k].reach + rounding)) return false;
  return true;
}

void LoopTurns::move(std::span<const RigidMotion> motions, std::span<const Vec3> from,
                     std::span<Vec3> x) const {
  RigidMotion now;
  std::size_t next = 0;
  const auto move_part = [&](const std::vector<Joint>& part) {
    for (const Joint joint : part) x[joint] = now(from[joint]);
  };
  for (const LoopResidue& one : loop_) {
    move_part(one.parts[0]);
    if (one.has_phi) now = motions[next++];
    move_part(one.parts[1]);
    if (one.has_psi) now = motions[next++];
    move_part(one.parts[2]);
  }
}

bool draw_loop(std::span<const LoopResidue> loop, std::span<const Vec3> start,
               std::span<const Vec3> from, RandomSequence& draws, std::span<Vec3> x) {
  const LoopTurns torsions(loop, start);
  const double share = least_share + (1.0 - least_share) * draws.uniform();
  std::vector<double> turns = torsions.draw(share, draws);
  LoopClosure closure(torsions.axes(), start[loop.back().c]);
  const auto wishes = [&](std::span<const double> now, std::span<double> out) {
    torsions.add_wishes(now, out);
  };
  if (!closure.close(turns, wishes) || !torsions.are_allowed(turns)) return false;
  torsions.move(closure.motions(turns), from, x);
  return true;
}

}  // namespace pliant
