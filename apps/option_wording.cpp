// SPDX-License-Identifier: MIT
#include "option_wording.hpp"

#include <fmt/format.h>

#include <limits>

namespace pliant::app {

std::string wording(std::int64_t least, std::int64_t most) {
  if (most == std::numeric_limits<std::int64_t>::max())
    return fmt::format("a whole number from {}", least);
  return fmt::format("a whole number from {} to {}", least, most);
}

std::string wording(Range range) {
  switch (range) {
    case Range::positive:
      return "a number above 0";
    case Range::zero_or_more:
      return "a number from 0";
    case Range::zero_to_one:
      return "a number from 0 to 1";
    case Range::any:
      break;
  }
  return "a number";
}

}  // namespace pliant::app
