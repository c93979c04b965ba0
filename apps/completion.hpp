// SPDX-License-Identifier: MIT
// pliant --completion SHELL: a script that lets a shell complete commands, options and files.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "command.hpp"

namespace pliant::app {

/// The script for bash, zsh or fish. It reads options from the help of a command when they are
/// needed, so that they belong to the installed version. Throws OptionError for another shell.
std::string completion_script(std::string_view shell, std::span<const Command> commands);

}  // namespace pliant::app
