// SPDX-License-Identifier: MIT
// What is told of a path, frame by frame.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/measures/contacts.hpp"
#include "pliant/path/ends.hpp"

namespace pliant {

/// One step of a path.
struct PathFrame {
  std::int64_t step = 0;
  double to_end = 0.0;  ///< r.m.s. distance of the asked atoms from the end, superposed, Angstrom
  double from_start = 0.0;    ///< the same from the start
  std::int64_t lost = 0;      ///< contacts that only the start has, and that are broken here
  std::int64_t made = 0;      ///< contacts that only the end has, and that are there
  double max_residual = 0.0;  ///< worst bar, share of its length
  double held_off = 0.0;      ///< furthest that a contact of both is outside its interval, Angstrom
  double overlap = 0.0;       ///< how much nearer than allowed two atoms are at most, Angstrom
  std::string tightest;       ///< these two: "A:LYS12 NZ - A:ASP54 OD1"; empty where none are
};

/// Looks at frames of the molecule of the start.
class PathTable {
 public:
  /// The ends must outlive it.
  explicit PathTable(const PathEnds& ends);

  /// Of positions (N, Angstrom) whose worst bar is off by max_residual of its length.
  PathFrame row(std::int64_t step, std::span<const Vec3> positions, double max_residual);

 private:
  void find_tightest(std::span<const Vec3> positions, PathFrame& row);

  const PathEnds& ends_;
  std::vector<Vec3> begun_;  ///< (K) Angstrom, where the asked atoms were at the start
  Contacts near_;
};

/// Two atoms that are too near each other, more than any others in some frames.
struct TightPlace {
  std::string atoms;        ///< "A:LYS12 NZ - A:ASP54 OD1"
  double overlap = 0.0;     ///< how much nearer than allowed, at most, Angstrom
  std::int64_t step = 0;    ///< where that is
  std::int64_t frames = 0;  ///< of which these two are the tightest
};

/// Pairs of atoms that are the tightest of a frame, the most overlapping first; at most `count`.
std::vector<TightPlace> tight_places(std::span<const PathFrame> frames, std::size_t count = 3);

}  // namespace pliant
