// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/resolve_options.hpp"

#include "pliant/base/range.hpp"

namespace pliant {

void check(const ResolveOptions& options) {
  check_range("tolerance", options.tolerance.relative, Range::positive);
  if (options.tolerance.length != 0.0)
    check_range("tolerance_length", options.tolerance.length, Range::positive);
  check_range("tolerance_limit", options.tolerance.limit, Range::positive);
  check_range("tolerance_overlap", options.tolerance.overlap, Range::positive);
  check_range("max_sweeps", options.max_sweeps, Range::positive);
}

}  // namespace pliant
