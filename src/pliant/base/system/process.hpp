// SPDX-License-Identifier: MIT
// This process, and others.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pliant {

/// The number by which the system knows this process. A forked one has another.
int process_id();

/// Returns the file of the program that runs; "" where the system does not say.
std::filesystem::path own_program();

/// Calls the functions around every fork of this process: before it, and after it in both. Does
/// nothing on a system that has no fork.
void call_around_fork(void (*before)(), void (*in_parent)(), void (*in_child)());

/// Calls `task` in a copy of this process, which may crash, and which ends with it. New memory is
/// filled there, so that reading what was never written crashes too. Returns the signal that ended
/// it, or 0; nothing where there is no copy to be had, as on Windows. A copy that takes more than
/// `most_seconds` of CPU time is ended.
std::optional<int> crash_in_copy(const std::function<void()>& task, unsigned most_seconds);

/// Whether there is a program of this name that this user may start.
bool is_program(const std::filesystem::path& path);

/// Returns the name of a program's file: with .exe on Windows.
std::string program_file(const std::string& name);

/// Sets a variable of the environment of this process, and of those that it starts, unless it is
/// set already.
void set_if_unset(const char* variable, const char* value);

using ProgramWords = std::vector<std::string>;

/// Goes on as another program, with these words after its name. Returns only if it cannot be
/// started, with the reason in errno. Windows cannot replace a process: it waits there, and ends as
/// the other program did.
void become_program(const std::filesystem::path& program, const ProgramWords& words);

/// Starts a program with `input` as its standard input, and waits. Returns its exit code, -1 if a
/// signal ended it; nothing if it cannot be started, with the reason in errno.
std::optional<int> run_program_with_input(const std::filesystem::path& program,
                                          const ProgramWords& words, std::string_view input);

}  // namespace pliant
