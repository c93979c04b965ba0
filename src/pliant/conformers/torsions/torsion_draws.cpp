// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/torsion_draws.hpp"

#include <algorithm>
#include <vector>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

constexpr double degree = 0.017453292519943295, quarter = 1.5707963267948966;
constexpr double thermal = 0.593;                   // kcal/mol, RT at 298 K
constexpr double energy_of_draws = 0.6;             // kcal/mol, of draws
constexpr double share_of_any = 0.2;                // crystals have unusual ones, too
constexpr double highest = 5.0;                     // kcal/mol, far from all peaks
constexpr double reach = 0.8;                       // widths
constexpr double half_of_12 = 0.10510423526567646;  // tangent

Turn of_angle(double radians) {
  return {exact_bits_cos(radians), exact_bits_cos(radians - quarter)};
}

/// A peak as draws and energies need it.
struct PeakDraw {
  Turn at;
  double until;         ///< sum of the weights of draws up to this one
  double weight;        ///< exp(-E / RT)
  double sharpness;     ///< 1 / width^2 (radians)
  double half_tangent;  ///< tangent of half of the largest deviation
};

struct KindDraw {
  std::vector<PeakDraw> peaks;
  double lowest = 0.0;
};

double raw_energy(const KindDraw& kind, Turn torsion) {
  double sum = exact_bits_exp(-highest / thermal);
  for (const PeakDraw& peak : kind.peaks) {
    const double cosine = peak.at.cosine * torsion.cosine + peak.at.sine * torsion.sine;
    sum += peak.weight * exact_bits_exp(peak.sharpness * (cosine - 1.0));
  }
  return -thermal * exact_bits_log(sum);
}

KindDraw kind_draw(const BondTurnEntry& row) {
  KindDraw kind;
  double sum = 0.0;
  const auto add = [&](double angle, const TorsionPeak& peak) {
    const double width = peak.width * degree;
    const Turn deviation = of_angle(reach * width);
    sum += exact_bits_exp(-peak.energy / energy_of_draws);
    kind.peaks.push_back({of_angle(angle * degree), sum, exact_bits_exp(-peak.energy / thermal),
                          1.0 / (width * width), deviation.sine / (1.0 + deviation.cosine)});
  };
  for (const TorsionPeak& peak : row.peaks) {
    add(peak.angle, peak);
    if (peak.angle > 0.0 && peak.angle < 180.0) add(-peak.angle, peak);
  }
  kind.lowest = 1e3;
  for (int k = 0; k < 360; ++k)
    kind.lowest = std::min(kind.lowest, raw_energy(kind, of_angle((k - 180) * degree)));
  return kind;
}

const KindDraw& draw_of(BondTurn kind) {
  static const std::vector<KindDraw> all = [] {
    std::vector<KindDraw> made;
    for (const BondTurnEntry& row : bond_turns()) made.push_back(kind_draw(row));
    return made;
  }();
  return all[static_cast<std::size_t>(kind)];
}

}  // namespace

Turn operator*(Turn one, Turn other) {
  return {one.cosine * other.cosine - one.sine * other.sine,
          one.sine * other.cosine + one.cosine * other.sine};
}

Turn of_half_tangent(double t) { return {(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)}; }

Turn nearest_usual(Turn torsion, BondTurn kind) {
  if (kind == BondTurn::any) return torsion;
  Turn nearest = torsion;
  double most = -2.0;
  for (const PeakDraw& peak : draw_of(kind).peaks) {
    const double cosine = peak.at.cosine * torsion.cosine + peak.at.sine * torsion.sine;
    if (cosine <= most) continue;
    most = cosine;
    nearest = peak.at;
  }
  return nearest;
}

Turn drawn_angle(RandomSequence& draws) {
  const Vec3 on_circle = draws.direction_in_plane();
  return {on_circle.x, on_circle.y};
}

/// Even but for the third order of the angle.
Turn drawn_jitter(RandomSequence& draws) {
  return of_half_tangent(half_of_12 * (2.0 * draws.uniform() - 1.0));
}

Turn drawn_usual(RandomSequence& draws, BondTurn kind) {
  if (draws.uniform() < share_of_any) return drawn_angle(draws);
  const std::vector<PeakDraw>& peaks = draw_of(kind).peaks;
  const double upto = peaks.back().until * draws.uniform();
  const auto peak = std::find_if(peaks.begin(), peaks.end() - 1,
                                 [&](const PeakDraw& at) { return upto < at.until; });
  return peak->at * of_half_tangent(peak->half_tangent * (2.0 * draws.uniform() - 1.0));
}

double torsion_energy(BondTurn kind, Turn torsion) {
  if (kind == BondTurn::any || stays(kind)) return 0.0;
  const KindDraw& row = draw_of(kind);
  return std::max(0.0, raw_energy(row, torsion) - row.lowest);
}

}  // namespace pliant
