// SPDX-License-Identifier: MIT
// Both ends go towards each other, until they meet or neither gains. Each has its own bars, so that
// frames of one cannot be frames of the other: where they have met, the molecule of the start goes
// on along the frames that the other has made, backwards, as its goals.
#pragma once

#include <string>
#include <vector>

#include "pliant/path/march.hpp"

namespace pliant {

class Meeting {
 public:
  /// Goes on from the one place of the way, where the walker of the start is. Ends (with an end
  /// that can move), walker and way must outlive it.
  Meeting(const PathEnds& ends, PathWalker& walker, Way& way, const PathOptions& options);

  /// One step at most of one of the two, in turn. False where they have met, or neither gains.
  bool advance();

  /// Of K places each: where the other was, last one first.
  std::vector<std::vector<Vec3>> goals() const;
  /// "the two ends met, 0.49 A apart, after 17 steps of the start and 16 of the end".
  std::string told() const;

 private:
  /// One of the two.
  struct Traveller {
    PathWalker& walker;
    Way& way;
    double left;  ///< Angstrom, if the other stood still
    Patience patience;
    bool waits = false;  ///< for good: steps gain no more
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
