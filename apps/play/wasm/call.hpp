// SPDX-License-Identifier: MIT
// The table of calls that a page may make.
#pragma once

#include <span>
#include <string_view>

#include "reply.hpp"

namespace pliant::play {

/// One call: what is asked as JSON, and the bytes of a file where there is one.
struct Request {
  const Json& fields;
  std::string_view bytes;
};

/// One row of the table of calls. Throws Error with Pliant's message; what was open is then as
/// before.
struct CallEntry {
  std::string_view name;
  Reply (*answer)(const Request& request);
};

std::span<const CallEntry> calls();

/// The reply of the call that request["do"] names: {ok: true, ...}, or {ok: false, error: message}.
Reply answer(const Request& request) noexcept;

}  // namespace pliant::play
