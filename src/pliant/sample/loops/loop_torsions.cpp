// SPDX-License-Identifier: MIT
#include "pliant/sample/loops/loop_torsions.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <span>

#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace {

constexpr double radians = std::numbers::pi / 180.0;

/// A peak of the plot: its share, place and widths (degrees).
struct Peak {
  double share, phi, psi, phi_width, psi_width;
};

constexpr Peak general[] = {{0.30, -120, 135, 25, 20},
                            {0.30, -70, 145, 13, 16},
                            {0.25, -65, -38, 12, 12},
                            {0.10, -95, -5, 15, 15},
                            {0.05, 58, 38, 8, 12}};
constexpr Peak before_proline[] = {
    {0.45, -120, 120, 25, 25}, {0.45, -72, 145, 13, 16}, {0.10, -62, -45, 10, 10}};
constexpr Peak glycine[] = {{0.35, 82, 10, 15, 18},
                            {0.20, -80, 170, 22, 22},
                            {0.15, 82, -170, 22, 22},
                            {0.15, -65, -35, 12, 12},
                            {0.15, 180, 180, 30, 25}};
constexpr Peak proline[] = {{0.60, -70, 148, 10, 15}, {0.40, -62, -30, 10, 14}};

std::span<const Peak> peaks_of(LoopResidueKind kind) {
  switch (kind) {
    case LoopResidueKind::before_proline:
      return before_proline;
    case LoopResidueKind::glycine:
      return glycine;
    case LoopResidueKind::proline:
      return proline;
    default:
      return general;
  }
}

}  // namespace

PhiPsi draw_phi_psi(LoopResidueKind kind, RandomSequence& draws) {
  const std::span<const Peak> peaks = peaks_of(kind);
  double left = draws.uniform();
  std::size_t at = 0;
  while (at + 1 < peaks.size() && (left -= peaks[at].share) >= 0.0) ++at;
  std::array<double, 2> off{};
  fill_normal(draws, off);
  return {radians * (peaks[at].phi + peaks[at].phi_width * off[0]),
          radians * (peaks[at].psi + peaks[at].psi_width * off[1])};
}

double loop_reach(LoopResidueKind kind, PhiPsi at) {
  const double reach = backbone_reach(at.phi, at.psi);
  if (kind != LoopResidueKind::glycine) return reach;
  return std::min(reach, backbone_reach(-at.phi, -at.psi));
}

BackboneTurn loop_turn(LoopResidueKind kind, PhiPsi at, double reach) {
  if (kind != LoopResidueKind::glycine ||
      backbone_reach(at.phi, at.psi) <= backbone_reach(-at.phi, -at.psi))
    return backbone_turn(at.phi, at.psi, reach);
  const BackboneTurn mirrored = backbone_turn(-at.phi, -at.psi, reach);
  return {-mirrored.phi, -mirrored.psi};
}

}  // namespace pliant
