// SPDX-License-Identifier: MIT
#include "pliant/base/system/signals.hpp"

#include <windows.h>

#include <atomic>

namespace pliant {
namespace {

std::atomic<void (*)(RequestToEnd)> ask_to_end{nullptr};

/// Runs in a thread of its own. After the end of a terminal Windows ends the process when this
/// returns: it waits for the end that was asked for.
BOOL WINAPI pass_on(DWORD request) {
  ask_to_end.load()(RequestToEnd::pressed);
  if (request != CTRL_C_EVENT && request != CTRL_BREAK_EVENT) ::Sleep(INFINITE);
  return TRUE;
}

}  // namespace

FileSizeSignalHeld::FileSizeSignalHeld() { static_cast<void>(was_held_); }
FileSizeSignalHeld::~FileSizeSignalHeld() = default;

void fail_writes_alone() {}

void call_on_request_to_end(void (*ask)(RequestToEnd)) {
  ask_to_end = ask;
  ::SetConsoleCtrlHandler(pass_on, TRUE);
}

void hold_requests_to_end() {}

}  // namespace pliant
