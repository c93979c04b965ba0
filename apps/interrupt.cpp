// SPDX-License-Identifier: MIT
#include "interrupt.hpp"

#include <unistd.h>

#include <atomic>
#include <csignal>

#include "command.hpp"

namespace pliant::app {
namespace {

std::atomic<bool> asked{false};
static_assert(std::atomic<bool>::is_always_lock_free);

std::atomic<bool> pressed{false};

void ask(int) {
  asked = true;
  if (pressed.exchange(true)) _exit(exit_interrupted);
}

/// As a queue asks before the time is up: once or several times, alone or with SIGTERM.
[[maybe_unused]] void ask_gently(int) { asked = true; }

}  // namespace

void watch_for_interrupt() {
  // A shell starts background jobs with Ctrl-C ignored: it is meant for the job in front. nohup
  // ignores the end of a terminal.
  for (const int signal : {SIGINT, SIGHUP})
    if (std::signal(signal, ask) == SIG_IGN) std::signal(signal, SIG_IGN);
  std::signal(SIGTERM, ask);
#ifdef SIGUSR1
  std::signal(SIGUSR1, ask_gently);
#endif
}

bool interrupted() { return asked.load(std::memory_order_relaxed); }

}  // namespace pliant::app
