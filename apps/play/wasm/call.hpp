// SPDX-License-Identifier: MIT
// The table of calls of the page.
#pragma once

#include <span>
#include <string_view>

#include "reply.hpp"

namespace pliant::play {

/// A call: its JSON, and the bytes of a file if there is one.
struct Request {
  const Json& fields;
  std::string_view bytes;
};

/// A row of the table of calls. Throws Error with Pliant's message and then leaves everything as it
/// was.
struct CallEntry {
  std::string_view name;
  Reply (*answer)(const Request& request);
};

std::span<const CallEntry> calls();

/// The reply of the call that request["do"] names: {ok: true, ...}, or {ok: false, error: message}.
Reply answer(const Request& request) noexcept;

}  // namespace pliant::play
