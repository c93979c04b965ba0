#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# build_dependencies.sh [TARGET...]: builds what a wheel has inside, as static libraries for the
# systems of targets.txt (this machine's, if none is given): zlib, bzip2, xz and HDF5 from Debian's
# sources, pugixml from the Python package. Into build/portable/TARGET; what is there is kept. HDF5
# is built with zlib and nothing else: Debian's has curl and Kerberos with it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly common=$PWD/build/portable # sources and headers, the same for all
# Of Debian: what the sources are taken from. HDF5 of bookworm asks the machine that compiles how it
# stores numbers; that of trixie asks the one that runs.
readonly suite=trixie
readonly jobs=${PLIANT_JOBS:-$(nproc)}

# shellcheck source=src/cmake/zig.sh
. src/cmake/zig.sh
# shellcheck source=python/wheel/targets.sh
. python/wheel/targets.sh
# own_apt ARGUMENT...: an apt-get that reads one list of its own, of the sources of another Debian, and
# knows of nothing that is installed. It checks what it fetches against Debian's keys.
own_apt() {
  local apt=$common/apt
  mkdir -p "$apt/lists/partial" "$apt/archives/partial"
  printf 'deb-src [signed-by=%s] http://deb.debian.org/debian %s main\n' \
    /usr/share/keyrings/debian-archive-keyring.gpg "$suite" >"$apt/sources.list"
  : >"$apt/status"
  apt-get -o Dir::Etc::SourceList="$apt/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o Dir::State::Lists="$apt/lists" -o Dir::State::status="$apt/status" \
    -o Dir::Cache::archives="$apt/archives" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= \
    -o APT::Sandbox::User=root "$@"
}

# The upstream archives alone: what Debian changes is for Debian.
fetch_sources() {
  own_apt update
  mkdir -p "$common/src"
  (cd "$common/src" && own_apt \
    source --download-only --tar-only --only-source zlib bzip2 xz-utils hdf5)
}

# unpack NAME: the archive of the Debian source NAME into src/NAME.
unpack() {
  rm -rf "$common/src/$1"
  mkdir -p "$common/src/$1"
  tar -xf "$(find "$common/src" -maxdepth 1 -name "$1_*.orig.tar.*[zb2]" | head -n 1)" \
    -C "$common/src/$1" --strip-components 1
}

need_sources() {
  local name
  [ ! -f "$common/src/whole-$suite" ] || return 0
  fetch_sources
  for name in zlib bzip2 xz-utils hdf5; do unpack "$name"; done
  touch "$common/src/whole-$suite"
}

# build_archive NAME HEADERS FLAGS SOURCE...: libNAME.a of C or C++ files that need no configuring.
build_archive() {
  local name=$1 headers=$2 flags=$3 source compiler objects=$folder/objects/$1
  mkdir -p "$objects"
  for source in "${@:4}"; do
    compiler=cc
    [[ $source != *.cpp ]] || compiler=c++
    # shellcheck disable=SC2086 # several flags, several headers
    "$folder/bin/$compiler" $cflags $flags -c "$source" -o "$objects/$(basename "$source").o"
  done
  "$folder/bin/ar" rcs "$folder/lib/lib$name.a" "$objects"/*.o
  # shellcheck disable=SC2086
  [ -z "$headers" ] || install -m 644 -t "$folder/include" $headers
}

build_zlib() {
  cd "$common/src/zlib"
  build_archive z 'zlib.h zconf.h' -DHAVE_UNISTD_H=1 ./*.c
}

build_bzip2() {
  cd "$common/src/bzip2"
  build_archive bz2 bzlib.h -D_FILE_OFFSET_BITS=64 \
    blocksort.c huffman.c crctable.c randtable.c compress.c decompress.c bzlib.c
}

build_pugixml() { build_archive pugixml '' -std=c++17 "$common/pugixml/pugixml.cpp"; }

# build_with_cmake NAME TARGET OPTION...
build_with_cmake() {
  cmake -S "$common/src/$1" -B "$folder/objects/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_TOOLCHAIN_FILE="$PWD/src/cmake/portable.cmake" -DPLIANT_PORTABLE="$folder" \
    -DCMAKE_C_FLAGS="$cflags" -DCMAKE_INSTALL_PREFIX="$folder" -DCMAKE_INSTALL_LIBDIR=lib \
    -DBUILD_SHARED_LIBS=OFF -DBUILD_TESTING=OFF "${@:3}"
  cmake --build "$folder/objects/$1" --target "$2" -j "$jobs"
}

build_xz() {
  build_with_cmake xz-utils liblzma -DCMAKE_C_FLAGS_RELEASE=-O2 -DXZ_NLS=OFF -DXZ_DOC=OFF
  install -m 644 "$folder/objects/xz-utils/liblzma.a" "$folder/lib"
  cp -R "$common/src/xz-utils/src/liblzma/api/lzma.h" "$common/src/xz-utils/src/liblzma/api/lzma" \
    "$folder/include"
}

# What its CMake would try by running it, it takes for granted where it cannot.
build_hdf5() {
  build_with_cmake hdf5 hdf5-static -DCMAKE_C_FLAGS_RELEASE=-Os -DHDF5_EXTERNALLY_CONFIGURED=1 \
    -DHDF5_ENABLE_Z_LIB_SUPPORT=ON -DZLIB_LIBRARY="$folder/lib/libz.a" \
    -DZLIB_INCLUDE_DIR="$folder/include" -DHDF5_ENABLE_SZIP_SUPPORT=OFF \
    -DHDF5_BUILD_TOOLS=OFF -DHDF5_BUILD_EXAMPLES=OFF -DHDF5_BUILD_HL_LIB=OFF \
    -DHDF5_BUILD_CPP_LIB=OFF -DHDF5_BUILD_FORTRAN=OFF
  install -m 644 "$(find "$folder/objects/hdf5" -name 'libhdf5*.a')" "$folder/lib/libhdf5.a"
  install -m 644 -t "$folder/include" "$common"/src/hdf5/src/{,H5FDsubfiling/}*.h \
    "$folder/objects/hdf5/src/H5pubconf.h"
}

# build_target NAME: in a shell of its own.
build_target() {
  folder=$common/$1
  # Whoever links these takes the functions that it calls, and shows none of them to others.
  cflags='-O2 -fPIC -w -ffunction-sections -fdata-sections -fvisibility=hidden'
  # HDF5 takes vasprintf from mingw, which has it for those who ask.
  [[ $1 != windows-* ]] || cflags+=' -D_GNU_SOURCE'
  mkdir -p "$folder/include" "$folder/lib"
  zig_tools "$folder/bin" -target "$(target_field "$1" zig)" -fno-sanitize=all
  [ ! -f "$folder/whole-$suite" ] || return 0
  for name in zlib bzip2 xz hdf5 pugixml; do
    (build_$name)
  done
  rm -rf "$folder/objects"
  touch "$folder/whole-$suite"
}

need_zig
system_headers "$common/headers"
pugixml_source "$common/pugixml"
need_sources
(($#)) || set -- "$(this_target)"
# All at once: CMake asks the compiler one thing after the other.
at_once build_target "$@"
