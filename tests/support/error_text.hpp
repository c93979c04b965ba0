// SPDX-License-Identifier: MIT
// The text of what a call throws, to be compared whole.
#pragma once

#include <string>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"

namespace pliant::test {

/// What error_text() gives where nothing is thrown.
inline constexpr const char* no_error = "(nothing was thrown)";

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
  return no_error;
}

}  // namespace pliant::test
