#!/usr/bin/env bash
# The Debian packages for this system, into build/packages, from the release build: `homolog`, the program, and `libhomolog-dev`, the library.
# `apt install ./build/packages/homolog_*.deb` installs the program with the packages that it needs.
set -euo pipefail
cd "$(dirname "$0")/.."

for tool in dpkg-shlibdeps:dpkg-dev file:file; do
  command -v "${tool%:*}" >/dev/null || { echo "build_deb: ${tool%:*} is missing; install the package ${tool#*:}." >&2; exit 1; }
done
options=()  # a first build leaves out the tests, an existing one stays as it is
[[ -f build/release/CMakeCache.txt ]] || options=(-DHOMOLOG_TESTS=OFF -DHOMOLOG_BENCH=OFF)
cmake --preset release "${options[@]}"
cmake --build --preset release --target homolog homolog_cli documents
rm -rf build/release/packages build/packages/*.deb && mkdir -p build/packages
(cd build/release && cpack -G DEB >packages.log) || { cat build/release/packages.log >&2; exit 1; }
cp build/release/packages/*.deb build/packages/
ls build/packages/*.deb
