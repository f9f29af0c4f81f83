#!/usr/bin/env bash
# Installs by apt what homolog needs on Debian 12 or Ubuntu (22.04, 24.04). Never asks; calls no apt when all is there.
#   scripts/install_dependencies.sh               everything, for scripts/test.sh
#   scripts/install_dependencies.sh --build-only  without what only tests and checks need, for scripts/demo.sh
#   scripts/install_dependencies.sh --fuzz        everything, and the newest clang, for scripts/fuzz.sh
set -euo pipefail
cd "$(dirname "$0")/.."

fail() { echo "install_dependencies: $*" >&2; exit 1; }

tests=yes wants_clang=no
case "${1:-}" in
  "") ;;
  --build-only) tests=no ;;
  --fuzz) wants_clang=yes ;;
  *) fail "unknown option '$1'; there are --build-only and --fuzz." ;;
esac

have() { command -v "$1" >/dev/null; }
installed() { [[ $(dpkg-query -W -f '${db:Status-Abbrev}' "$1" 2>/dev/null) == ii* ]]; }
node_is_new_enough() { have npm && have node && [[ "$(node -p 'process.versions.node.split(".")[0] >= 18')" == true ]]; }
have_clang_tidy() { for v in 16 17 18 19 20; do have "clang-tidy-$v" && return; done; return 1; }
# Newest first; libFuzzer and the sanitizers stand in a package beside the compiler.
clangs=(22 21 20 19 18 17 16 15 14)
have_fuzzing_clang() { for v in "${clangs[@]}"; do if have "clang++-$v" && installed "libclang-rt-$v-dev"; then return; fi; done; return 1; }
have_browser() { have chromium || have google-chrome || have google-chrome-stable; }

if ! have dpkg-query || ! have apt-get; then fail "this script knows only apt; elsewhere install the packages named in it by hand."; fi

# A tool may come from anywhere (command:package); a library must be apt's.
tools=(g++:g++ cmake:cmake ninja:ninja-build pkg-config:pkg-config)
# assimp's CMake target names zlib, but its package does not bring it.
libraries=(libeigen3-dev libtbb-dev libassimp-dev zlib1g-dev libminizip-dev libexpat1-dev libcli11-dev libfmt-dev nlohmann-json3-dev)
if [[ $tests == yes ]]; then
  tools+=(ccache:ccache python3:python3 clang-format-14:clang-format-14  # 14 is in all three systems, so all agree on the format
    groff:groff mandoc:mandoc zsh:zsh fish:fish dpkg-shlibdeps:dpkg-dev file:file valgrind:valgrind qemu-x86_64:qemu-user)
  libraries+=(libgtest-dev libgmock-dev libbenchmark-dev fonts-dejavu-core python3-dev python3-venv libegl1 libosmesa6)
fi

missing=()
for pair in "${tools[@]}"; do have "${pair%%:*}" || missing+=("${pair##*:}"); done
for package in "${libraries[@]}"; do installed "$package" || missing+=("$package"); done
node_is_new_enough || missing+=(nodejs npm)
wants_clang_tidy=no wants_browser=no
if [[ $tests == yes ]]; then
  have_clang_tidy || wants_clang_tidy=yes
  have_browser || wants_browser=yes
fi
if [[ $wants_clang == yes ]] && have_fuzzing_clang; then wants_clang=no; fi
if [[ ${#missing[@]} -eq 0 && $wants_clang_tidy == no && $wants_browser == no && $wants_clang == no ]]; then exit 0; fi

as_root=()
if [[ $EUID -ne 0 ]]; then
  have sudo || fail "run it as root or install sudo; it has to install: ${missing[*]}."
  as_root=(sudo)
fi
apt() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@"; }
# Not grep -q: it stops reading at the first hit, apt-cache dies of the closed pipe, and pipefail takes that for "no".
offers() { apt-cache show "$1" 2>/dev/null | grep '^Filename:' >/dev/null; }

mkdir -p build
log=build/install.log
apt update >"$log" 2>&1 || { tail -5 "$log" >&2; fail "'apt-get update' failed; is the network there? (all of it: $log)"; }

if [[ $wants_clang_tidy == yes ]]; then
  for version in 16 17 18 19 20; do
    if offers "clang-tidy-$version"; then missing+=("clang-tidy-$version"); break; fi
  done
  [[ "${missing[*]}" == *clang-tidy* ]] || echo "install_dependencies: no clang-tidy from 16 on in this system; scripts/check.sh will leave it out." >&2
fi
if [[ $wants_clang == yes ]]; then
  for version in "${clangs[@]}"; do
    if offers "clang-$version" && offers "libclang-rt-$version-dev"; then missing+=("clang-$version" "libclang-rt-$version-dev"); break; fi
  done
  [[ "${missing[*]}" == *libclang-rt* ]] || fail "this system offers no clang with libFuzzer."
fi
# Ubuntu has Chromium only as a snap, which cannot run everywhere; Playwright's own build stands in for it below.
if [[ $wants_browser == yes ]] && offers chromium; then missing+=(chromium); wants_browser=no; fi

if [[ ${#missing[@]} -gt 0 ]]; then
  echo "Installing by apt: ${missing[*]}"
  apt install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1 ||
    { grep -E '^(E|dpkg):|rror' "$log" | tail -5 >&2; fail "'apt-get install' failed. (all of it: $log)"; }
fi
node_is_new_enough || fail "the report's viewer needs Node.js 18 or newer, and this system offers $(node --version 2>/dev/null || echo none); install a newer one and run this again."
if [[ $wants_browser == yes ]]; then
  echo "Installing Chromium by Playwright, as /usr/local/bin/chromium"
  { (cd viewer && npm ci && npx playwright-core install --with-deps chromium) &&
    "${as_root[@]}" ln -sf "$(cd viewer && node -p 'require("playwright-core").chromium.executablePath()')" /usr/local/bin/chromium; } >>"$log" 2>&1 ||
    fail "no Chromium could be installed for the viewer's tests; install one as 'chromium' and run this again. (all of it: $log)"
fi
