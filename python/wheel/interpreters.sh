# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by what builds wheels: which versions of Python are here. Called in the root of the
# repository.

say_version() { "$1" -c 'import sys; print("%d.%d" % sys.version_info[:2])' 2>/dev/null; }

# One path a line: of each version that has a wheel of its own the first that can make environments.
# Where pyenv keeps interpreters off PATH they are looked for too.
interpreters() {
  local version path
  for version in 3.10 3.11 3.12; do
    for path in .venv/bin/python "python$version" "$HOME/.pyenv/versions/$version".*/bin/python; do
      command -v "$path" >/dev/null && [ "$(say_version "$path")" = "$version" ] &&
        "$path" -c 'import ensurepip' 2>/dev/null && printf '%s\n' "$path" && break
    done
  done
}
