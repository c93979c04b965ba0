// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <atomic>
#include <cstdlib>

#include "command.hpp"
#include "pliant/base/system/signals.hpp"

namespace pliant::app {
namespace {

std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<bool> pressed{false};

void ask(RequestToEnd request) {
  asked = true;
  if (request == RequestToEnd::pressed && pressed.exchange(true)) std::_Exit(exit_interrupted);
}

}  // namespace

void watch_for_interrupt() { call_on_request_to_end(ask); }

bool interrupted() { return asked.load(std::memory_order_relaxed); }

}  // namespace pliant::app
