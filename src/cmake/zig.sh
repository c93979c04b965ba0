# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by the builds that need a compiler for another system than this one: clang as the Python
# package ziglang has it, and headers and sources that belong to no system. Called in the root of
# the repository; .venv is there.

readonly ziglang=0.17.1
readonly pugixml=0.8.0
readonly pugixml_hash=0f05bee514c59f76892f12c5dfc8270a09909f1d7730218540ce3aca3188ae92

zig= # its folder

# Installs zig where it is missing, and sets `zig` to its folder.
need_zig() {
  local version
  version=$(.venv/bin/python -c 'import importlib.metadata as m; print(m.version("ziglang"))' 2>/dev/null || true)
  [ "$version" = "$ziglang" ] || .venv/bin/pip install --quiet "ziglang==$ziglang"
  zig=$(.venv/bin/python -c 'import os, ziglang; print(os.path.dirname(ziglang.__file__))')
}

# zig_tools FOLDER [FLAG...]: cc, c++, ar and ranlib there, the first two with the flags: CMake and
# ccache want compilers that are one program each.
zig_tools() {
  local into=$1 tool flags
  mkdir -p "$into"
  for tool in cc c++ ar ranlib; do
    flags=${*:2}
    case $tool in ar | ranlib) flags= ;; esac
    printf '#!/bin/sh\nexec "%s/zig" %s %s "$@"\n' "$zig" "$tool" "$flags" >"$into/$tool.new"
    chmod +x "$into/$tool.new"
    cmp -s "$into/$tool.new" "$into/$tool" || mv "$into/$tool.new" "$into/$tool"
    rm -f "$into/$tool.new"
  done
}

# system_headers FOLDER: of the system's headers those that are no part of its C library.
system_headers() {
  local name
  mkdir -p "$1"
  for name in CLI eigen3 fmt gemmi nlohmann tao; do
    ln -sfn "/usr/include/$name" "$1/$name"
  done
}

# pugixml_source FOLDER: it lies in the Python package of that name; Debian has a library alone.
pugixml_source() {
  [ ! -f "$1/LICENSE.md" ] || return 0
  local scratch
  scratch=$(mktemp -d)
  printf 'pugixml==%s --hash=sha256:%s\n' "$pugixml" "$pugixml_hash" >"$scratch/pugixml.txt"
  .venv/bin/pip download --quiet --no-binary :all: --no-deps --no-build-isolation \
    --require-hashes --requirement "$scratch/pugixml.txt" --dest "$scratch"
  mkdir -p "$1"
  tar -xzf "$scratch/pugixml-$pugixml.tar.gz" -C "$1" --strip-components 5 \
    "pugixml-$pugixml/src/third_party/pugixml/src"
  tar -xzf "$scratch/pugixml-$pugixml.tar.gz" -C "$1" --strip-components 4 \
    "pugixml-$pugixml/src/third_party/pugixml/LICENSE.md"
  rm -r "$scratch"
}
