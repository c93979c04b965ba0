// SPDX-License-Identifier: MIT
// The table of a path: measures of each frame.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/path/ends.hpp"

namespace pliant {

/// One step of a path.
struct PathFrame {
  std::int64_t step = 0;
  double to_end = 0.0;  ///< r.m.s. distance of the asked atoms from the end, superposed, Angstrom
  double from_start = 0.0;    ///< the same from the start
  std::int64_t lost = 0;      ///< broken contacts among those that only the start has
  std::int64_t made = 0;      ///< formed contacts among those that only the end has
  double max_residual = 0.0;  ///< worst bar, relative to its length
  double held_off = 0.0;  ///< largest distance of a shared contact outside its interval, Angstrom
  double overlap = 0.0;   ///< by how much two atoms are nearer than allowed, Angstrom
  std::string tightest;   ///< these two: "A:LYS12 NZ - A:ASP54 OD1"; empty if there are none
};

/// Measures frames of the molecule of the start.
class PathTable {
 public:
  /// The ends must outlive it.
  explicit PathTable(const PathEnds& ends);

  /// Measures positions (N, Angstrom), whose worst bar has the relative error max_residual.
  PathFrame row(std::int64_t step, std::span<const Vec3> positions, double max_residual);

 private:
  void find_tightest(std::span<const Vec3> positions, PathFrame& row);

  const PathEnds& ends_;
  std::vector<Vec3> begun_;  ///< (K) Angstrom, asked atoms at the start
  NeighbourList near_;
};

/// Two atoms that are too near each other, more than any others in some frames.
struct TightPlace {
  std::string atoms;        ///< "A:LYS12 NZ - A:ASP54 OD1"
  double overlap = 0.0;     ///< by how much at most, Angstrom
  std::int64_t step = 0;    ///< of the largest overlap
  std::int64_t frames = 0;  ///< number of frames in which these two are the tightest
};

/// Pairs of atoms that are the tightest of a frame, the most overlapping first; at most `count`.
std::vector<TightPlace> tight_places(std::span<const PathFrame> frames, std::size_t count = 3);

}  // namespace pliant
