// SPDX-License-Identifier: MIT
#include "pliant/framework/frame.hpp"

namespace pliant {

std::string_view name(Stop stop) {
  switch (stop) {
    case Stop::converged:
      return "converged";
    case Stop::max_sweeps:
      return "max_sweeps";
    case Stop::not_finite:
      return "not_finite";
    case Stop::stopped_by_caller:
      return "stopped_by_caller";
  }
  return "unknown";
}

}  // namespace pliant
