// SPDX-License-Identifier: MIT
// Frame (snapshot): what a run shows its observers after a step, and what a recorder writes.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Why a resolve ended.
enum class Stop : std::uint8_t {
  converged,          ///< all is within the tolerance
  max_sweeps,         ///< the limit was reached first
  not_finite,         ///< a length became infinite or not a number; positions were put back
  stopped_by_caller,  ///< a callback asked to stop
};

/// "converged", "max_sweeps", ...
std::string_view name(Stop stop);

/// How the target of a sampled frame was drawn: a row of drawn_by_table() each. Files record the
/// number: a new one comes last.
enum class DrawnBy : std::uint8_t {
  other,             ///< by a sampler that draws in one way only
  modes,             ///< along the modes of a network
  wide_modes,        ///< likewise, twice as far
  turns,             ///< domains turned
  turns_with_modes,  ///< in files of earlier versions: with a draw of the modes inside them
  pocket,            ///< a place opened or closed, with a draw of the modes
  ligand,            ///< the same, and a ligand in it has other torsions
};

struct DrawnByEntry {
  DrawnBy drawn_by;
  std::string_view name;
  bool is_near;  ///< around the start: flexibility is computed from such frames
};
std::span<const DrawnByEntry> drawn_by_table();

inline constexpr std::int64_t no_joint = -1;

/// One step's result. Spans are valid during the call only.
struct Frame {
  std::int64_t step = 0;
  double time = 0.0;                ///< ps
  std::span<const Vec3> positions;  ///< (N) Angstrom, all finite
  std::int64_t sweeps = 0;          ///< sweeps of the technique's ordering in this step
  std::int64_t projections = 0;     ///< bars looked at in this step
  double max_residual = 0.0;        ///< largest |length - rest| / rest
  double rms_residual = 0.0;        ///< root mean square of it
  Stop stop = Stop::converged;
  std::int64_t root_joint = no_joint;  ///< where the technique began; no_joint before any step
  Vec3 force;                          ///< on root_joint, kJ/(mol Angstrom); 0 if none
  double max_limit = 0.0;    ///< largest distance of a limit outside its interval (Angstrom)
  double max_overlap = 0.0;  ///< largest overlap of two joints (Angstrom)
  /// (N) Angstrom, one step earlier, from which a run can continue; empty if not known.
  std::span<const Vec3> previous = {};
  /// (L) 1: the limit is switched off; empty: all are on
  std::span<const std::uint8_t> limits_off = {};
  std::int64_t redraws = 0;  ///< draws that a sampler rejected before this frame was resolved
  DrawnBy drawn_by = DrawnBy::other;
  std::int64_t walker = 0;  ///< the walker it belongs to, where one file holds several
};

}  // namespace pliant
