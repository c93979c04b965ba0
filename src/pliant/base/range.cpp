// SPDX-License-Identifier: MIT
#include "pliant/base/range.hpp"

#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

std::string_view words_of_real(Range range) {
  switch (range) {
    case Range::positive:
      return "positive and finite";
    case Range::zero_or_more:
      return "0 or more and finite";
    case Range::zero_to_one:
      return "from 0 to 1";
    case Range::any:
      break;
  }
  return "finite";
}

std::string_view words_of_whole(Range range) {
  switch (range) {
    case Range::positive:
      return "from 1";
    case Range::zero_to_one:
      return "0 or 1";
    case Range::zero_or_more:
    case Range::any:
      break;
  }
  return "from 0";
}

[[noreturn]] void refuse(std::string_view name, const std::string& value, std::string_view words) {
  throw OptionError(std::string(name) + " = " + value + ": must be " + std::string(words));
}

}  // namespace

bool holds(Range range, double value) {
  if (!std::isfinite(value)) return false;
  switch (range) {
    case Range::positive:
      return value > 0.0;
    case Range::zero_or_more:
      return value >= 0.0;
    case Range::zero_to_one:
      return value >= 0.0 && value <= 1.0;
    case Range::any:
      break;
  }
  return true;
}

bool holds(Range range, std::int64_t value) {
  switch (range) {
    case Range::positive:
      return value >= 1;
    case Range::zero_or_more:
      return value >= 0;
    case Range::zero_to_one:
      return value == 0 || value == 1;
    case Range::any:
      break;
  }
  return true;
}

void check_range(std::string_view name, double value, Range range) {
  if (!holds(range, value)) refuse(name, number_text(value), words_of_real(range));
}

void check_range(std::string_view name, std::int64_t value, Range range) {
  if (!holds(range, value)) refuse(name, std::to_string(value), words_of_whole(range));
}

}  // namespace pliant
