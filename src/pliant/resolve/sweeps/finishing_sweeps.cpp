// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/finishing_sweeps.hpp"

#include "pliant/resolve/sweeps/sweeps.hpp"

namespace pliant {

Stop FinishingSweeps::resolve(const ResolveCall& call, ResolveSummary& summary) {
  if (!sweeps_) sweeps_ = make_sweeps(framework_, technique_, options_);
  const std::int64_t before = summary.sweeps;
  const Stop stop = sweeps_->resolve(call, summary);
  summary.finishing_sweeps = summary.sweeps - before;
  return stop;
}

}  // namespace pliant
