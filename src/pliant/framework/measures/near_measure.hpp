// SPDX-License-Identifier: MIT
// Measures what few joints take part in, at a cost that does not depend on the size of the
// framework.
#pragma once

#include <cmath>
#include <memory>
#include <span>

#include "pliant/framework/measures/joint_neighbours.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// Not thread-safe.
class NearMeasure {
 public:
  /// The framework must outlive it.
  NearMeasure(const Framework& framework, const Tolerance& tolerance)
      : framework_(framework), tolerance_(tolerance) {}

  /// Prepares for `positions` (N, Angstrom). If `continues`, only `joints` have moved since the
  /// last call of begin() or look(); else all may have, which costs O(N) where there are sterics.
  /// Returns false if positions cannot be listed.
  bool begin(std::span<const Vec3> positions, std::span<const Joint> joints, bool continues);
  /// Says that these have moved.
  void look(std::span<const Vec3> positions, std::span<const Joint> joints);

  /// Adds bars, limits and near joints of `joint` to `found`, without the bars to joints of which
  /// `is_done(other)` holds; its rms_relative stays as it is.
  template <class IsDone>
  void measure_at(std::span<const Vec3> positions, Joint joint, LimitsOff off,
                  ResidualSummary& found, const IsDone& is_done) const {
    measure_bars(positions, joint, found, is_done);
    if (!framework_.has_bars_only()) measure_contacts(positions, joint, off, found);
  }

  /// After begin(): the joints near each joint; null where the framework has no sterics.
  JointNeighbours* neighbours() { return neighbours_.get(); }

 private:
  template <class IsDone>
  void measure_bars(std::span<const Vec3> positions, Joint joint, ResidualSummary& found,
                    const IsDone& is_done) const {
    for (const Incidence& at : framework_.neighbours(joint)) {
      if (is_done(at.joint)) continue;
      const double rest = framework_.rest_lengths()[at.bar];
      const double error = std::abs(residual(positions[joint], positions[at.joint], rest));
      if (!(error <= tolerance_.of(rest))) found.within = false;
      if (!std::isfinite(error)) found.finite = false;
      if (!(error / rest > found.max_relative)) continue;
      found.max_relative = error / rest;
      found.worst_bar = at.bar;
    }
  }
  void measure_contacts(std::span<const Vec3> positions, Joint joint, LimitsOff off,
                        ResidualSummary& found) const;
  void measure_limits(std::span<const Vec3> positions, Joint joint, LimitsOff off,
                      ResidualSummary& found) const;
  void measure_overlaps(std::span<const Vec3> positions, Joint joint, ResidualSummary& found) const;

  const Framework& framework_;
  Tolerance tolerance_;
  std::unique_ptr<JointNeighbours> neighbours_;
};

}  // namespace pliant
