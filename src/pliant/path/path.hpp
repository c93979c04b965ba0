// SPDX-License-Identifier: MIT
// Path (targeting, morphing): a sequence of whole frames from one structure of a molecule to
// another. At each step the other structure is superposed on the molecule, whose residues are asked
// to move towards it by a fixed r.m.s. distance; technique `froda` then makes bars whole, keeps
// atoms apart and holds the contacts that both structures have. Contacts that only one has are
// released (S. Wells et al., Phys. Biol. 2 (2005) S127; D. W. Farrell, K. Speranskiy, M. F. Thorpe,
// Proteins 78 (2010) 2908). Where that does not arrive, pieces that keep their shape turn as
// wholes.
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

/// A path that is found step by step. The same ends, options and seed give the same bits. Not
/// thread-safe.
class PathWalk {
 public:
  /// The ends must have been matched with the same options. Throws OptionError, and InputError as
  /// Motion.
  PathWalk(std::shared_ptr<const PathEnds> ends, const PathOptions& options);
  ~PathWalk();
  PathWalk(PathWalk&&) noexcept;

  /// Makes at most one step of either molecule. Returns false when the walk has ended. A step that
  /// should_stop cuts short changes nothing.
  bool advance();
  bool is_over() const;

  /// Number of frames of the start on the best way so far. It grows with the steps of the first
  /// way; one with turns or a detour replaces that once it has come nearer. After the end these are
  /// the path.
  std::size_t frame_count() const;
  /// A frame, numbered from 0; times are 0.01 ps apart, since a path has no time. Positions remain
  /// valid as long as the frame belongs to this walk.
  Frame frame(std::size_t number) const;
  /// Distance of the last frame from the end (Angstrom).
  double left() const;
  /// Number of detours tried.
  std::int64_t attempts() const;
  /// How often another way has replaced the best.
  std::int64_t replaced() const;
  /// Degrees: the largest turn of a piece of the molecule that the best way was guessed with; 0
  /// where it is straight.
  double turned() const;
  /// How residues were matched, where the ends met, and why the walk ended.
  std::vector<std::string> notes() const;

  const std::shared_ptr<const PathEnds>& ends() const;
  const PathOptions& options() const;

 private:
  struct Search;
  std::unique_ptr<Search> search_;
};

/// A path and its costs.
struct MolecularPath {
  std::shared_ptr<const PathEnds> ends;
  std::vector<std::vector<Vec3>>
      positions;                   ///< (F) of N each, Angstrom; atoms of the start's model
  std::vector<PathFrame> frames;   ///< (F) the start first
  std::vector<std::string> notes;  ///< how residues were matched, where the ends met, why it ended
  std::int64_t attempts = 0;       ///< number of detours tried
  double turned = 0.0;             ///< degrees, as PathWalk::turned
  bool has_arrived = false;        ///< the last frame has reached the end
};

/// The table of the frames that a walk has so far.
std::vector<PathFrame> table_of(const PathWalk& walk);

/// The path that a walk has found so far.
MolecularPath found_by(const PathWalk& walk);

/// Moves `start` towards `end`, another structure of the same molecule, until nothing more is
/// gained or should_stop asks for an end. Both must have their bonds (perceive_bonds). Throws
/// OptionError, and InputError if the two do not match.
MolecularPath find_path(const Structure& start, const Structure& end,
                        const PathOptions& options = {});

}  // namespace pliant
