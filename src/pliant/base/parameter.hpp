// SPDX-License-Identifier: MIT
// Parameter: the value of one option of a run, as files keep it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

namespace pliant {

/// The value of one option of a run, as stored under /parameters.
using Parameter = std::variant<std::int64_t, double, bool, std::string>;

/// An option's place below /parameters ("run/seed") and its value.
using NamedParameter = std::pair<std::string, Parameter>;

}  // namespace pliant
