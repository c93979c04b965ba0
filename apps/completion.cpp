// SPDX-License-Identifier: MIT
#include "completion.hpp"

#include <array>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"

namespace pliant::app {
namespace {

/// Reads a help: long options stand at the beginning of a line, perhaps after a short one;
/// subcommands two blanks after the beginning, below the line "subcommands:". fish has its own
/// words.
constexpr std::string_view readers = R"shell(_pliant_options() {
  "$@" --help-all 2>/dev/null | sed -nE 's/^  +(-[a-zA-Z][^-]*, *|-[a-zA-Z],)?(--[a-z][a-z-]*).*/\2/p'
}
_pliant_subcommands() {
  "$@" --help 2>/dev/null | sed -nE '/^subcommands:/,/^$/s/^  ([a-z][a-z-]+)  .*/\1/p'
}
)shell";

constexpr std::string_view for_bash = R"shell(# bash completion of pliant: add to ~/.bashrc
#   source <(pliant --completion bash)
@READERS@_pliant() {
  local word=${COMP_WORDS[COMP_CWORD]} called=("${COMP_WORDS[0]}" "${COMP_WORDS[1]-}")
  COMPREPLY=()
  if ((COMP_CWORD == 1)); then
    mapfile -t COMPREPLY < <(compgen -W "@COMMANDS@ --help --help-all --version --completion" -- "$word")
    return
  fi
  local at=2
  while ((at < COMP_CWORD)) && [[ ${COMP_WORDS[at]} =~ ^[a-z][a-z-]*$ ]] &&
    _pliant_subcommands "${called[@]}" | grep -qx -- "${COMP_WORDS[at]}"; do
    called+=("${COMP_WORDS[at]}")
    at=$((at + 1))
  done
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$(_pliant_options "${called[@]}")" -- "$word")
  elif ((COMP_CWORD == at)); then
    mapfile -t COMPREPLY < <(compgen -W "$(_pliant_subcommands "${called[@]}")" -- "$word")
  fi
}
complete -o bashdefault -o default -F _pliant pliant
)shell";

constexpr std::string_view for_zsh = R"shell(#compdef pliant
# zsh completion of pliant: add to ~/.zshrc, after compinit
#   source <(pliant --completion zsh)
@READERS@_pliant() {
  local -a found called
  called=(${words[1]} ${words[2]})
  if ((CURRENT == 2)); then
    found=(@DESCRIBED@)
    _describe command found
    return
  fi
  local at=3
  while ((at < CURRENT)) && _pliant_subcommands $called | grep -qx -- "${words[at]}"; do
    called+=(${words[at]})
    at=$((at + 1))
  done
  if [[ ${words[CURRENT]} == -* ]]; then
    found=(${(f)"$(_pliant_options $called)"})
    compadd -a found
    return
  fi
  if ((CURRENT == at)); then
    found=(${(f)"$(_pliant_subcommands $called)"})
    compadd -a found
  fi
  _files
}
compdef _pliant pliant
)shell";

constexpr std::string_view for_fish = R"shell(# fish completion of pliant:
#   pliant --completion fish > ~/.config/fish/completions/pliant.fish
function __pliant_called
  set -l called (commandline -opc)
  test (count $called) -ge 2; or return
  set -l command $called[1..2]
  for word in $called[3..-1]
    contains -- $word (__pliant_subcommands $command); or break
    set -a command $word
  end
  string join \n -- $command
end
function __pliant_options
  set -l command (__pliant_called)
  test (count $command) -ge 2; or return
  $command --help-all 2>/dev/null | string replace -rf '^  +(?:-[a-zA-Z][^-]*, *|-[a-zA-Z],)?(--[a-z][a-z-]*).*' '$1'
end
function __pliant_subcommands
  $argv --help 2>/dev/null | sed -nE '/^subcommands:/,/^$/s/^  ([a-z][a-z-]+)  .*/\1/p'
end
function __pliant_at_command
  test (count (commandline -opc)) -eq 1
end
function __pliant_next
  set -l command (__pliant_called)
  test (count $command) -eq (count (commandline -opc)); and __pliant_subcommands $command
end
function __pliant_at_subcommand
  test (count (commandline -opc)) -ge 2
end
function __pliant_at_option
  string match -q -- '-*' (commandline -ct)
end
@ADDED@complete -c pliant -n __pliant_at_subcommand -a '(__pliant_next)'
complete -c pliant -n __pliant_at_option -f -a '(__pliant_options)'
)shell";

/// A row of the table of shells.
struct Shell {
  std::string_view name;
  std::string_view script;  ///< with a word between @ where `word` stands
  std::string_view mark;
  std::string (*line)(const Command& command);  ///< of each command, in its place
};

/// Where a mark stands, if it does.
void put(std::string& script, std::string_view mark, std::string_view text) {
  const std::size_t place = script.find(mark);
  if (place != script.npos) script.replace(place, mark.size(), text);
}

/// The text between single quotes.
std::string quoted_for_shell(std::string_view text) {
  std::string quoted = "'";
  for (char letter : text) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

constexpr std::array shells{
    Shell{"bash", for_bash, "@COMMANDS@",
          [](const Command& command) { return std::string(command.name) + " "; }},
    Shell{"zsh", for_zsh, "@DESCRIBED@",
          [](const Command& command) {
            return quoted_for_shell(std::string(command.name) + ":" +
                                    std::string(command.summary)) +
                   " ";
          }},
    Shell{"fish", for_fish, "@ADDED@",
          [](const Command& command) {
            return "complete -c pliant -n __pliant_at_command -f -a " + std::string(command.name) +
                   " -d " + quoted_for_shell(command.summary) + "\n";
          }},
};

}  // namespace

std::string completion_script(std::string_view shell, std::span<const Command> commands) {
  const Shell& chosen = choose(std::span<const Shell>(shells), "shell", shell);
  std::string lines;
  for (const Command& command : commands) lines += chosen.line(command);
  while (lines.ends_with(' ')) lines.pop_back();
  std::string script(chosen.script);
  put(script, "@READERS@", readers);
  put(script, chosen.mark, lines);
  return script;
}

}  // namespace pliant::app
