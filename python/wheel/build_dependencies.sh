#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds what a wheel has inside, as static libraries for glibc 2.28 and later: zlib, bzip2, xz and
# HDF5 from Debian's sources, pugixml from the Python package. Into build/portable; what is there is
# kept. HDF5 is built with zlib and nothing else: Debian's has curl and Kerberos with it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

readonly folder=$PWD/build/portable
readonly suite=bookworm # of Debian: what the sources are taken from
readonly jobs=${PLIANT_JOBS:-$(nproc)}
machine=$(uname -m)
readonly machine

# shellcheck source=src/cmake/zig.sh
. src/cmake/zig.sh
need_zig
zig_tools "$folder/bin" -target "$machine-linux-gnu.2.28" -fno-sanitize=all
system_headers "$folder/headers"
pugixml_source "$folder/pugixml"
export CC=$folder/bin/cc CXX=$folder/bin/c++ AR=$folder/bin/ar RANLIB=$folder/bin/ranlib
# Whoever links these takes the functions that it calls, and shows none of them to others.
export CFLAGS='-O2 -fPIC -w -ffunction-sections -fdata-sections -fvisibility=hidden'

# apt reads one list of its own, and checks what it fetches against Debian's keys.
apt_source() {
  apt-get -o Dir::Etc::SourceList="$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null \
    -o Dir::State::Lists="$folder/lists" -o APT::Sandbox::User=root "$@"
}

fetch_sources() {
  printf 'deb-src [signed-by=%s] http://deb.debian.org/debian %s main\n' \
    /usr/share/keyrings/debian-archive-keyring.gpg "$suite" >"$folder/sources.list"
  mkdir -p "$folder/lists/partial" "$folder/src"
  apt_source update
  (cd "$folder/src" && apt_source source --download-only zlib bzip2 xz-utils hdf5)
}

# unpack NAME: the upstream archive of the Debian source NAME into src/NAME.
unpack() {
  rm -rf "$folder/src/$1"
  mkdir -p "$folder/src/$1"
  tar -xf "$(find "$folder/src" -maxdepth 1 -name "$1_*.orig.tar.*[zb2]" | head -n 1)" \
    -C "$folder/src/$1" --strip-components 1
  cd "$folder/src/$1"
}

build_zlib() {
  unpack zlib
  ./configure --static --prefix="$folder"
  make -j"$jobs" libz.a
  make install
}

build_bzip2() {
  unpack bzip2
  make -j"$jobs" libbz2.a CC="$CC" AR="$AR" RANLIB="$RANLIB" CFLAGS="$CFLAGS"
  install -m 644 -t "$folder/include" bzlib.h
  install -m 644 -t "$folder/lib" libbz2.a
}

build_xz() {
  unpack xz-utils
  ./configure --prefix="$folder" --disable-shared --enable-static --disable-doc --disable-nls \
    --disable-xz --disable-xzdec --disable-lzmadec --disable-lzmainfo --disable-scripts
  make -j"$jobs"
  make install
}

# Its configure writes C of before 1999, which clang refuses unless told otherwise.
build_hdf5() {
  unpack hdf5
  CFLAGS="$CFLAGS -Os -Wno-error=implicit-int -Wno-error=implicit-function-declaration" \
    ./configure --prefix="$folder" --disable-shared --enable-static --disable-hl --disable-tests \
    --disable-tools --without-szlib --with-zlib="$folder"
  make -j"$jobs" -C src
  make -C src install
}

build_pugixml() {
  # shellcheck disable=SC2086 # several flags
  "$CXX" -std=c++17 $CFLAGS -c "$folder/pugixml/pugixml.cpp" -o "$folder/pugixml/pugixml.o"
  "$AR" rcs "$folder/lib/libpugixml.a" "$folder/pugixml/pugixml.o"
}

mkdir -p "$folder/include" "$folder/lib"
[ -f "$folder/whole" ] && exit
fetch_sources
for name in zlib bzip2 xz hdf5 pugixml; do
  (build_$name)
done
touch "$folder/whole"
