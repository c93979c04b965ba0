#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# try_on_debian.sh SUITE: installs the wheel of build/wheels that fits into a bare Debian, such as
# bookworm or trixie, which has Python and nothing else, and runs `pliant demo` there. As root;
# needs debootstrap. The Debian is made once, in build/debian/SUITE.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

suite=$1
root=$PWD/build/debian/$suite
readonly suite root

bare_debian() {
  [ -x "$root/usr/bin/python3" ] && return
  mkdir -p build/debian
  rm -rf "$root"
  debootstrap --variant=minbase --include=python3-venv "$suite" "$root" http://deb.debian.org/debian
}

# What pip would fetch is fetched out here: the Debian in there may have no network.
collect_wheels() {
  local version
  version=$(chroot "$root" python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
  rm -rf "$root/wheels" "$root/venv" "$root/demo"
  mkdir "$root/wheels"
  cp build/wheels/*.whl "$root/wheels"
  .venv/bin/pip download --quiet --only-binary :all: --python-version "$version" \
    --dest "$root/wheels" numpy h5py
}

inside() {
  chroot "$root" env PATH=/venv/bin:/usr/bin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"
}

bare_debian
collect_wheels
inside python3 -m venv /venv
time inside pip install --quiet --no-index --find-links /wheels pliant
time inside pliant demo -o /demo
inside pliant --version
