// SPDX-License-Identifier: MIT
// Walkers in step with each other, resolved together if their pushes are alike. Those that lanes
// cannot take go one after another.
#pragma once

#include <vector>

#include "pliant/run/showing.hpp"
#include "pliant/run/walk.hpp"

namespace pliant {

class Together {
 public:
  /// All must outlive it. Throws as run().
  Together(const Framework& framework, std::span<WalkerRun> walkers, const RunOptions& options);

  std::vector<RunSummary> run();

 private:
  struct Shown {
    Walk walk;
    Showing showing;
    bool goes_on;  ///< continues an earlier run

    bool is_over() const { return showing.is_over(walk); }
  };

  void run_one(Shown& walker);
  bool step();
  void push();
  void part_alike();
  void resolve_alike();
  static void finish(Shown& walker, const ResolveSummary& resolved);

  WalkerResolver resolver_;
  std::vector<Shown> walkers_;
  std::vector<Shown*> alone_, alike_;  ///< in this step
  std::vector<WalkerPositions> positions_;
  std::vector<ResolveSummary> resolved_;
};

}  // namespace pliant
