# SPDX-License-Identifier: MIT
# shellcheck shell=bash
# Sourced by ./dev: the page that ./dev play has built is kept by the hash of all that it is built
# from, so that ./dev test can look at it without building it.

readonly kept_pages=${XDG_CACHE_HOME:-$HOME/.cache}/pliant
readonly tested_page=build/tested_page # where ./dev test puts it

# A word for all that the page is built from: sources, examples, and the versions of other people's
# headers. Of src what WebAssembly leaves out is left out (src/pliant/CMakeLists.txt).
page_key() {
  {
    find CMakeLists.txt LICENSE src apps/play data/proteins data/molecules data/mechanisms -type f \
      ! -name '*.md' ! -path 'apps/play/test/*' ! -path 'src/pliant/stream/*' \
      ! -path 'src/pliant/lab/test_sets/*' ! -path 'src/pliant/record/h*.cpp' -print0 |
      LC_ALL=C sort -z | xargs -0 sha256sum
    dpkg-query -W gemmi-dev libeigen3-dev libfmt-dev nlohmann-json3-dev tao-pegtl-dev 2>/dev/null || true
  } | sha256sum | cut -c1-16
}

# keep_page KEY: as it is once it has another name; the five newest stay.
keep_page() {
  local kept=$kept_pages/page-$1
  mkdir -p "$kept_pages"
  cp build/play/pliant.wasm "$kept.wasm"
  cp build/play/pliant.html "$kept.html.new"
  mv "$kept.html.new" "$kept.html"
  find "$kept_pages" -name 'page-*.html' -printf '%T@ %p\n' | sort -rn | tail -n +6 |
    cut -d' ' -f2- | while read -r old; do rm -f "$old" "${old%.html}.wasm"; done
}

# Whether the page of these sources has been kept; then it is where the tests look.
page_for_tests() {
  rm -rf "$tested_page"
  mkdir -p "$tested_page"
  local kept
  kept=$kept_pages/page-$(page_key).html
  [ -f "$kept" ] && cp "$kept" "$tested_page/pliant.html"
}
