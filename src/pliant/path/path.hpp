// SPDX-License-Identifier: MIT
// Path (targeting, morphing): a way from one structure of a molecule to another, each frame whole.
// At each step the other structure is superposed on the molecule, whose residues are asked to go
// towards it by a fixed r.m.s. distance; technique `froda` then makes bars whole, keeps atoms apart
// and holds the contacts that both structures have. Those of one alone are let go (S. Wells et al.,
// Phys. Biol. 2 (2005) S127; D. W. Farrell, K. Speranskiy, M. F. Thorpe, Proteins 78 (2010) 2908).
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "pliant/framework/frame.hpp"
#include "pliant/path/ends.hpp"
#include "pliant/path/path_options.hpp"
#include "pliant/path/path_table.hpp"

namespace pliant {

/// A path as it is found, step by step. The same ends, options and seed give the same bits. Not for
/// two threads at once.
class PathWalk {
 public:
  /// The ends were matched with the same options. Throws OptionError, and InputError as Motion.
  PathWalk(std::shared_ptr<const PathEnds> ends, const PathOptions& options);
  ~PathWalk();
  PathWalk(PathWalk&&) noexcept;

  /// One step at most, of either molecule. False where the walk has ended: then nothing moves any
  /// more. A step that should_stop cut short leaves all as it was.
  bool advance();
  bool is_over() const;

  /// Frames of the start on the best way so far, which grows with the steps of the first; a detour
  /// takes its place once it has come nearer. After the end they are the path.
  std::size_t frame_count() const;
  /// One of them, numbered from 0; 0.01 ps apart, for a path has no time. Positions stay valid as
  /// long as it is a frame of this walk.
  Frame frame(std::size_t number) const;
  /// How far the last of them is from the end (Angstrom).
  double left() const;
  /// How often it went back and tried again.
  std::int64_t attempts() const;
  /// How residues were matched, where the ends met, why it ended.
  std::vector<std::string> notes() const;

  const std::shared_ptr<const PathEnds>& ends() const;
  const PathOptions& options() const;

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

/// A path, and what it took.
struct MolecularPath {
  std::shared_ptr<const PathEnds> ends;
  std::vector<std::vector<Vec3>>
      positions;                   ///< (F) of N each, Angstrom; atoms of the start's model
  std::vector<PathFrame> frames;   ///< (F) the start first
  std::vector<std::string> notes;  ///< how residues were matched, where the ends met, why
                                   ///< it ended
  std::int64_t attempts = 0;       ///< times that it went back and tried again
  bool has_arrived = false;        ///< whether the last frame is at the end
};

/// What is told of the frames that a walk has so far.
std::vector<PathFrame> table_of(const PathWalk& walk);

/// What a walk has found so far.
MolecularPath found_by(const PathWalk& walk);

/// Moves `start` towards `end`, another structure of the same molecule, until nothing is gained or
/// should_stop asks for an end. Both with their bonds (perceive_bonds).
/// Throws OptionError, and InputError where the two do not match.
MolecularPath find_path(const Structure& start, const Structure& end,
                        const PathOptions& options = {});

}  // namespace pliant
