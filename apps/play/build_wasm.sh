#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds build/play/pliant.wasm: the library and the calls of apps/play/wasm. What has been built is
# kept in build/wasm; only what changed is compiled. Prints the size.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly folder=$PWD/build/wasm
readonly output=$PWD/build/play
mkdir -p "$folder" "$output"

# shellcheck source=src/cmake/zig.sh
. src/cmake/zig.sh
need_zig
zig_tools "$folder/bin"
system_headers "$folder/headers"
pugixml_source "$folder/pugixml"

cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/src/cmake/wasm32-wasi.cmake" \
  -DCMAKE_C_COMPILER="$folder/bin/cc" -DCMAKE_CXX_COMPILER="$folder/bin/c++" \
  -DCMAKE_AR="$folder/bin/ar" -DCMAKE_RANLIB="$folder/bin/ranlib" \
  -DPLIANT_WASM=ON -DPLIANT_APPS=OFF -DPLIANT_TESTS=OFF -DPLIANT_UNITY=ON \
  -DPLIANT_HEADERS="$folder/headers" -DPLIANT_PUGIXML="$folder/pugixml" \
  -DPLIANT_WASM_OUTPUT="$output" -DZIG_LIB_DIR="$zig/lib" >"$folder/cmake.log"
nice -n 5 ninja -C "$folder" "-j${PLIANT_JOBS:-2}" ${PLIANT_KEEP_GOING:+-k 0} pliant_play

# Whose code is in the module: licences as they come with it, for the page.
notice() { # NAME FILE
  printf '%s\n\n' "$1"
  cat "$2"
  printf '\n\n'
}
{
  notice 'LLVM: libc++, libc++abi, libunwind' "$zig/lib/libcxx/LICENSE.TXT"
  notice 'wasi-libc' "$zig/lib/libc/wasi/LICENSE"
  notice 'musl, in wasi-libc' "$zig/lib/libc/wasi/libc-top-half/musl/COPYRIGHT"
  notice 'cloudlibc, in wasi-libc' "$zig/lib/libc/wasi/libc-bottom-half/cloudlibc/LICENSE"
  notice 'zig' "$zig/LICENSE"
  notice 'pugixml' "$folder/pugixml/LICENSE.md"
  for package in libeigen3 gemmi tao-pegtl libfmt nlohmann-json3; do
    notice "$package (headers of Debian)" "/usr/share/doc/$package-dev/copyright"
  done
} >"$output/notices.txt"
stat --format='%n: %s bytes' "$output/pliant.wasm"
