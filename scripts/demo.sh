#!/usr/bin/env bash
# From a fresh clone to a report to look at: installs, builds, takes two real teddies in two poses from a Debian package, and
# matches them. All it makes lies in build/.
set -euo pipefail
cd "$(dirname "$0")/.."

fail() { echo "demo: $*" >&2; exit 1; }
say() { echo; echo "== $*"; }

# bear.off and bear_bis.off (CC0) stand in CGAL's collection of meshes, which apt brings without installing it.
fetch_teddies() {
  [[ -f build/demo/bear.off && -f build/demo/bear_bis.off ]] && return
  local as_root=() scratch=build/demo/package
  [[ $EUID -eq 0 ]] || as_root=(sudo)
  rm -rf "$scratch" && mkdir -p "$scratch"
  (cd "$scratch" && apt-get -qq download libcgal-demo) 2>"$scratch/log" ||
    { "${as_root[@]}" apt-get -qq update && (cd "$scratch" && apt-get -qq download libcgal-demo); } 2>"$scratch/log" ||
    fail "apt could not fetch the package libcgal-demo: $(tail -1 "$scratch/log")"
  dpkg-deb -x "$scratch"/libcgal-demo*.deb "$scratch"
  find "$scratch" -name 'data*.tar.gz' -exec \
    tar xzf {} -C build/demo --strip-components=2 --wildcards '*/meshes/bear.off' '*/meshes/bear_bis.off' ';'
  [[ -f build/demo/bear.off && -f build/demo/bear_bis.off ]] || fail "this system's libcgal-demo holds no bear.off and bear_bis.off."
  rm -rf "$scratch"
}

match() {
  build/release/cli/homolog match "$@" || fail "the match failed with exit code $?."
}

say "Installing what the build needs"
scripts/install_dependencies.sh --build-only

say "Building"
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
options=()  # a first build leaves out the tests, an existing one stays as it is
[[ -f build/release/CMakeCache.txt ]] || options=(-DHOMOLOG_TESTS=OFF -DHOMOLOG_BENCH=OFF)
cmake --preset release "${options[@]}" || fail "CMake could not configure the build."
cmake --build --preset release || fail "the build failed."

say "Fetching two teddies"
fetch_teddies

say "The whole of one against the whole of the other"
match build/demo/bear.off build/demo/bear_bis.off --out build/demo/whole

say "The upper half of one against the whole of the other"
match build/demo/bear.off build/demo/bear_bis.off --model-part 'y>0.5' --out build/demo/part

say "Done. Open these two reports in a browser:"
echo "$PWD/build/demo/whole/report.html"
echo "$PWD/build/demo/part/report.html"
