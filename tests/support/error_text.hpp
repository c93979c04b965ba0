// SPDX-License-Identifier: MIT
// The text of what a call throws, to be compared whole.
#pragma once

#include <string>

#include "pliant/base/error.hpp"

namespace pliant::test {

/// what() of the `Kind` that `call` throws; "" if it throws nothing.
template <class Kind, class Call>
std::string error_text(Call&& call) {
  try {
    call();
  } catch (const Kind& error) {
    return error.what();
  } catch (const std::exception& error) {
    return "(another kind of error: " + std::string(error.what()) + ")";
  }
  return "";
}

}  // namespace pliant::test

/// That the call after `text` throws a `Kind` whose what() is `text`.
#define EXPECT_ERROR(Kind, text, ...) \
  EXPECT_EQ(::pliant::test::error_text<Kind>([&] { __VA_ARGS__; }), text)
