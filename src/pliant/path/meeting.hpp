// SPDX-License-Identifier: MIT
// Both ends move towards each other, until they meet or neither gains. Each has its own bars, so
// that frames of one are not frames of the other: from the meeting on, the molecule of the start
// takes the frames of the other, backwards, as its goals.
#pragma once

#include <string>
#include <vector>

#include "pliant/path/march.hpp"

namespace pliant {

class Meeting {
 public:
  /// Continues from the one place of the way, where the walker of the start is. Ends (with an end
  /// that can move), walker and way must outlive it.
  Meeting(const PathEnds& ends, PathWalker& walker, Way& way, const PathOptions& options);

  /// Makes at most one step of one end, in turn. Returns false when they have met, or neither
  /// gains.
  bool advance();

  /// Goals of K positions each: the places of the other end, the last one first.
  std::vector<std::vector<Vec3>> goals() const;
  /// "the two ends met, 0.49 A apart, after 17 steps of the start and 16 of the end".
  std::string summary() const;

 private:
  /// One of the two ends.
  struct Traveller {
    PathWalker& walker;
    Way& way;
    double left;  ///< Angstrom, as long as the other does not move
    Patience patience;
    bool waits = false;  ///< has stopped, because steps gain no more
  };

  bool go(Traveller& here, const PathWalker& there);

  const PathEnds& ends_;
  double step_;
  PathWalker other_walker_;
  Way other_way_;
  Traveller ours_, theirs_;
  std::size_t turns_ = 0;
};

}  // namespace pliant
