// SPDX-License-Identifier: MIT
// Sweeps of all bars that a direct method could not finish: redundant bars far from whole,
// coincident joints, impossible lengths.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Plain sweeps by `bfs_reverse` 0.5, counted as finishing_sweeps. Allocates memory at its first
/// use.
class FinishingSweeps {
 public:
  /// Both must outlive it.
  FinishingSweeps(const Framework& framework, bool mass_weighted, const ResolveOptions& options)
      : framework_(framework), technique_{"bfs_reverse", 0.5, mass_weighted}, options_(options) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary);

 private:
  const Framework& framework_;
  Technique technique_;
  const ResolveOptions& options_;
  std::unique_ptr<Method> sweeps_;
};

}  // namespace pliant
