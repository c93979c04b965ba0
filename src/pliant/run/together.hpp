// SPDX-License-Identifier: MIT
// Walkers in step with each other, resolved together if their pushes are alike.
#pragma once

#include <vector>

#include "pliant/resolve/walkers.hpp"
#include "pliant/run/showing.hpp"
#include "pliant/run/walk.hpp"

namespace pliant {

class Together {
 public:
  /// All must outlive it; the resolver is of this framework and these options, and may have served
  /// other walkers. Throws as run().
  Together(const Framework& framework, WalkerResolver& resolver, std::span<WalkerRun> walkers,
           const RunOptions& options);

  std::vector<RunSummary> run();

 private:
  struct Shown {
    Walk walk;
    Showing showing;
    bool goes_on;  ///< continues an earlier run

    bool is_over() const { return showing.is_over(walk); }
  };

  bool step();
  void push();
  void part_alike();
  void resolve_alike();
  static void finish(Shown& walker, const ResolveSummary& resolved);

  WalkerResolver& resolver_;
  std::vector<Shown> walkers_;
  std::vector<Shown*> alone_, alike_;  ///< in this step
  std::vector<WalkerPositions> positions_;
  std::vector<ResolveSummary> resolved_;
};

}  // namespace pliant
