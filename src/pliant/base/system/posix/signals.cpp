// SPDX-License-Identifier: MIT
#include "pliant/base/system/signals.hpp"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <initializer_list>

namespace pliant {
namespace {

sigset_t file_size_signal() {
  sigset_t signals{};
  sigemptyset(&signals);
  sigaddset(&signals, SIGXFSZ);
  return signals;
}

/// Takes away what waits. macOS has no sigtimedwait().
void forget_waiting(const sigset_t& signals) {
#if defined(__APPLE__)
  sigset_t waiting{};
  while (sigpending(&waiting) == 0 && sigismember(&waiting, SIGXFSZ) == 1) {
    int taken = 0;
    if (sigwait(&signals, &taken) != 0) return;
  }
#else
  constexpr timespec at_once{0, 0};
  while (sigtimedwait(&signals, nullptr, &at_once) == SIGXFSZ) {
  }
#endif
}

std::atomic<void (*)(RequestToEnd)> ask_to_end{nullptr};
static_assert(std::atomic<void (*)(RequestToEnd)>::is_always_lock_free);

void pass_on(int signal) {
  ask_to_end.load()(signal == SIGUSR1 ? RequestToEnd::ahead_of_time : RequestToEnd::pressed);
}

}  // namespace

FileSizeSignalHeld::FileSizeSignalHeld() {
  const sigset_t signals = file_size_signal();
  sigset_t before{};
  pthread_sigmask(SIG_BLOCK, &signals, &before);
  was_held_ = sigismember(&before, SIGXFSZ) == 1;
}

FileSizeSignalHeld::~FileSizeSignalHeld() {
  if (was_held_) return;
  const sigset_t signals = file_size_signal();
  forget_waiting(signals);
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void fail_writes_alone() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void call_on_request_to_end(void (*ask)(RequestToEnd)) {
  ask_to_end = ask;
  // A shell starts background jobs with Ctrl-C ignored: it is meant for the job in front. nohup
  // ignores the end of a terminal.
  for (const int signal : {SIGINT, SIGHUP})
    if (std::signal(signal, pass_on) == SIG_IGN) std::signal(signal, SIG_IGN);
  for (const int signal : {SIGTERM, SIGUSR1}) std::signal(signal, pass_on);
}

void hold_requests_to_end() {
  sigset_t signals{};
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGHUP, SIGTERM, SIGUSR1}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

}  // namespace pliant
