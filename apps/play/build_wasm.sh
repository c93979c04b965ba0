#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds build/play/pliant.wasm: the library and the calls of apps/play/wasm. What has been built is
# kept in build/wasm; only what changed is compiled. Prints the size.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly folder=$PWD/build/wasm
readonly output=$PWD/build/play
readonly ziglang=0.17.1
readonly pugixml=0.8.0
readonly pugixml_hash=0f05bee514c59f76892f12c5dfc8270a09909f1d7730218540ce3aca3188ae92
mkdir -p "$folder/bin" "$folder/headers" "$output"

# The compiler: a Python package.
version_here() {
  .venv/bin/python -c 'import importlib.metadata as m; print(m.version("ziglang"))' 2>/dev/null || true
}
[ "$(version_here)" = "$ziglang" ] || .venv/bin/pip install --quiet "ziglang==$ziglang"
zig=$(.venv/bin/python -c 'import os, ziglang; print(os.path.dirname(ziglang.__file__))')

# pugixml's source lies in the Python package of that name: Debian has it as a library alone.
if [ ! -f "$folder/pugixml/LICENSE.md" ]; then
  printf 'pugixml==%s --hash=sha256:%s\n' "$pugixml" "$pugixml_hash" >"$folder/pugixml.txt"
  .venv/bin/pip download --quiet --no-binary :all: --no-deps --no-build-isolation \
    --require-hashes --requirement "$folder/pugixml.txt" --dest "$folder/sdist"
  mkdir -p "$folder/pugixml"
  tar -xzf "$folder/sdist/pugixml-$pugixml.tar.gz" -C "$folder/pugixml" --strip-components 5 \
    "pugixml-$pugixml/src/third_party/pugixml/src"
  tar -xzf "$folder/sdist/pugixml-$pugixml.tar.gz" -C "$folder/pugixml" --strip-components 4 \
    "pugixml-$pugixml/src/third_party/pugixml/LICENSE.md"
fi

# Of the system's headers those that are no part of its C library.
for name in eigen3 fmt gemmi nlohmann tao; do
  ln -sfn "/usr/include/$name" "$folder/headers/$name"
done

# CMake and ccache want compilers that are one program each.
for tool in cc c++ ar ranlib; do
  printf '#!/bin/sh\nexec "%s/zig" %s "$@"\n' "$zig" "$tool" >"$folder/bin/$tool.new"
  chmod +x "$folder/bin/$tool.new"
  cmp -s "$folder/bin/$tool.new" "$folder/bin/$tool" || mv "$folder/bin/$tool.new" "$folder/bin/$tool"
done

cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_TOOLCHAIN_FILE="$PWD/src/cmake/wasm32-wasi.cmake" \
  -DCMAKE_C_COMPILER="$folder/bin/cc" -DCMAKE_CXX_COMPILER="$folder/bin/c++" \
  -DCMAKE_AR="$folder/bin/ar" -DCMAKE_RANLIB="$folder/bin/ranlib" \
  -DPLIANT_WASM=ON -DPLIANT_APPS=OFF -DPLIANT_TESTS=OFF -DPLIANT_UNITY=ON \
  -DPLIANT_WASM_HEADERS="$folder/headers" -DPLIANT_WASM_PUGIXML="$folder/pugixml" \
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
