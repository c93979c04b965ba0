// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "pliant/base/system/path_text.hpp"

int main(int argc, char** argv) {
  return pliant::app::run_command(pliant::command_words(argc, argv));
}
