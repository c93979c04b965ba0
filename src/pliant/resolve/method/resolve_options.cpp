// SPDX-License-Identifier: MIT
#include "pliant/resolve/method/resolve_options.hpp"

#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {

void check(const ResolveOptions& options) {
  const auto positive = [](const char* name, double value) {
    if (!(value > 0.0 && std::isfinite(value)))
      throw OptionError(std::string(name) + " = " + number_text(value) +
                        ": must be positive and finite");
  };
  positive("tolerance", options.tolerance.relative);
  if (options.tolerance.length != 0.0) positive("tolerance_length", options.tolerance.length);
  positive("tolerance_limit", options.tolerance.limit);
  positive("tolerance_overlap", options.tolerance.overlap);
  if (options.max_sweeps < 1)
    throw OptionError("max_sweeps = " + std::to_string(options.max_sweeps) + ": must be from 1");
}

}  // namespace pliant
