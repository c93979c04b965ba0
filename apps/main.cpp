// SPDX-License-Identifier: MIT
#include "commands.hpp"

int main(int argc, char** argv) { return pliant::app::run_command(argc, argv); }
