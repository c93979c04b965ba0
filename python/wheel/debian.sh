# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by what takes sources and packages of another Debian than the one it runs on.

# begin_apt FOLDER TYPE SUITE [OPTION...]: an apt that reads one list of its own and knows of nothing
# that is installed. It checks what it fetches against Debian's keys. TYPE is deb or deb-src.
begin_apt() {
  mkdir -p "$1/lists/partial" "$1/archives/partial"
  printf '%s [signed-by=%s] http://deb.debian.org/debian %s main\n' \
    "$2" /usr/share/keyrings/debian-archive-keyring.gpg "$3" >"$1/sources.list"
  : >"$1/status"
  own_apt "$1" "${@:4}" update
}

# own_apt FOLDER ARGUMENT...: apt-get with what begin_apt wrote.
own_apt() {
  apt-get -o Dir::Etc::SourceList="$1/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o Dir::State::Lists="$1/lists" -o Dir::State::status="$1/status" \
    -o Dir::Cache::archives="$1/archives" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= \
    -o APT::Sandbox::User=root "${@:2}"
}
