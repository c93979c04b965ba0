// SPDX-License-Identifier: MIT
// How the library speaks: through a callback that the caller gives, and in no other way.
#pragma once

#include <functional>
#include <string_view>

namespace pliant {

/// detail: what was done, as always ("132 waters taken out").
/// note: something worth knowing that is as it should be ("model 1 of 2 used").
/// warning: a guess was made or something was left out.
enum class Severity { detail, note, warning };

/// Receives each message; empty means silence.
using LogFunction = std::function<void(Severity, std::string_view)>;

/// A log function with the three verbs that call it; cheap to copy and pass by const reference.
struct Log {
  LogFunction function = {};

  void detail(std::string_view text) const {
    if (function) function(Severity::detail, text);
  }
  void note(std::string_view text) const {
    if (function) function(Severity::note, text);
  }
  void warn(std::string_view text) const {
    if (function) function(Severity::warning, text);
  }
};

}  // namespace pliant
