// SPDX-License-Identifier: MIT
// The text of what a call throws, to be compared whole.
#pragma once

#include <string>

#include "pliant/base/error.hpp"

namespace pliant::test {

/// what() of the `Kind` that `call` throws; a text that no error has if it throws none.
template <class Kind, class Call>
std::string error_text(Call&& call) {
  try {
    call();
  } catch (const Kind& error) {
    return error.what();
  } catch (const std::exception& error) {
    return "(another kind of error: " + std::string(error.what()) + ")";
  }
  return "(nothing was thrown)";
}

}  // namespace pliant::test
