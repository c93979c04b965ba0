#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# emulated_python.sh TARGET: what the wheel of another processor is tried with under qemu: Debian's
# Python for it in build/portable/TARGET/debian, and the wheel of build/wheels that fits, with what
# it needs, in build/portable/TARGET/packages. The same packages for this machine, to compare with,
# in build/portable/linux-.../packages.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

# shellcheck source=python/wheel/targets.sh
. python/wheel/targets.sh
# shellcheck source=python/wheel/debian.sh
. python/wheel/debian.sh
# shellcheck source=python/wheel/interpreters.sh
. python/wheel/interpreters.sh

readonly target=$1 portable=$PWD/build/portable
readonly needed=(numpy h5py scipy pytest)

# The version of Python of a Debian that a wheel is there for, and that Debian.
if compgen -G "build/wheels/*-cp311-*$(target_field "$target" platform).whl" >/dev/null; then
  readonly version=3.11 suite=bookworm
else
  readonly version=3.13 suite=trixie
fi

# Debian's packages are unpacked, not installed: nothing of theirs runs.
need_python() {
  local folder=$portable/$target/debian processor=arm64 package
  [ ! -x "$folder/usr/bin/python$version" ] || return 0
  rm -rf "$folder"
  begin_apt "$folder/apt" deb "$suite" -o "APT::Architecture=$processor"
  own_apt "$folder/apt" -o "APT::Architecture=$processor" -o "APT::Architectures=$processor" \
    install --yes --no-install-recommends --download-only "python$version" libstdc++6
  for package in "$folder"/apt/archives/*.deb; do dpkg-deb --extract "$package" "$folder"; done
  [ -e "$folder/lib" ] || ln -s usr/lib "$folder/lib" # of the package base-files, from trixie on
  rm -rf "$folder/apt"
}

# install_packages TARGET VERSION: pip fetches wheels of any processor, and unpacks them.
install_packages() {
  local into=$portable/$1/packages processor=${1#linux-}
  local options=(--quiet --upgrade --target "$into" --only-binary :all: --python-version "$2"
    --platform "manylinux_2_28_$processor" --platform "manylinux_2_27_$processor"
    --platform "manylinux2014_$processor")
  .venv/bin/python -m pip install "${options[@]}" "${needed[@]}"
  .venv/bin/python -m pip install "${options[@]}" --no-index --no-deps --find-links build/wheels pliant
}

need_python
install_packages "$target" "$version"
install_packages "$(this_target)" "$(say_version .venv/bin/python)"
