#!/usr/bin/env bash
# Installs, builds and runs all tests, then the quick checks of scripts/check.sh; ends with a line per step.
#   scripts/test.sh        the release build: unit, command line, report in a browser, installed package, Python, documentation; then
#                          the unit tests but for the whole way, and the program, with AddressSanitizer and UndefinedBehaviorSanitizer
#   scripts/test.sh --all  besides: the whole way there; markups against 3D Slicer's own code, which pip brings (160 MB); the program under
#                          valgrind; the unit tests with ThreadSanitizer, which must see a planted race; and clang-tidy
set -euo pipefail
cd "$(dirname "$0")/.."

all=no
case "${1:-}" in
  "") ;;
  --all) all=yes ;;
  *) echo "test: unknown option '$1'; the only one is --all." >&2; exit 2 ;;
esac

summary=() failed=no
# step NAME COMMAND...: runs it, remembers how it went and goes on, so that one run tells all that is wrong.
step() {
  local name=$1 start=$SECONDS word=passed
  shift
  echo; echo "== $name"
  "$@" || { word=FAILED; failed=yes; }
  summary+=("$(printf '%-10s %-7s %4d s' "$name" "$word" $((SECONDS - start)))")
  [[ $word == passed ]]
}
finish() {
  echo; echo "== summary"
  printf '%s\n' "${summary[@]}"
  [[ $failed == no ]]
  exit
}

# shellcheck disable=SC2317  # the functions below are called through step
configure_and_build() { cmake --preset "$1" -DHOMOLOG_TESTS=ON -DHOMOLOG_BENCH=ON && cmake --build --preset "$@"; }
# The whole way takes a third of the unit tests' time, and the program goes it in the next step, so sanitized.
# shellcheck disable=SC2317
sanitized_tests() {
  local tests=-WholeWay.*
  [[ $all == no ]] || tests=*
  configure_and_build dev --target unit_tests &&
    GTEST_FILTER=$tests ASAN_OPTIONS=detect_stack_use_after_return=1 ctest --preset dev -R '^unit'
}
# Without the tests of limits of memory (memory; those in others leave themselves out), those that take long for one answer (odd,
# repeatability), and those of other programs (report, install, package).
# shellcheck disable=SC2317
sanitized_program() {
  configure_and_build dev --target homolog_cli example_01_match example_02_stages example_03_match_stages &&
    ctest --preset dev -R '^(cli|faults|symmetry|transfer|refusals|volumes|morph|dense|overwrite|mutation)$'
}
# shellcheck disable=SC2317
valgrind_program() {
  local folder=build/valgrind homolog=(valgrind -q --error-exitcode=9 build/release/cli/homolog) coarse=(--resolution 64 --threads 2)
  mkdir -p "$folder" && PYTHONPATH=tests/cli python3 -B -c '
import pathlib, sys, bear, cloud_files, volume_files
folder = pathlib.Path(sys.argv[1])
bear.write_all(folder)
(folder / "labels.nii").write_bytes(volume_files.nifti())
(folder / "cloud.xyz").write_bytes(cloud_files.xyz())' "$folder" &&
    "${homolog[@]}" match "$folder/bear.off" "$folder/bear_bis.off" "${coarse[@]}" &&
    "${homolog[@]}" points "$folder/labels.nii" "${coarse[@]}" && "${homolog[@]}" points "$folder/cloud.xyz" "${coarse[@]}"
}
# shellcheck disable=SC2317
threaded_tests() {
  local tests=build/tsan/tests/unit_tests race=(--gtest_also_run_disabled_tests --gtest_filter='*PlantedRace')
  configure_and_build tsan --target unit_tests && "$tests" --gtest_brief=1 || return 1
  if TSAN_OPTIONS=exitcode=66 "$tests" "${race[@]}" &>/dev/null || [[ $? -ne 66 ]]; then echo "a planted race was not seen" >&2; return 1; fi
}

# From the same compiler and nanobind's same place each time, so that ccache has the library from the build before.
# shellcheck disable=SC2317
python_package() {
  local pip=(build/venv/bin/pip -q --disable-pip-version-check)
  python3 -m venv build/venv && "${pip[@]}" install scikit-build-core nanobind &&
    CXX=${CXX:-c++} "${pip[@]}" install --no-build-isolation --check-build-dependencies ".[test$([[ $all == no ]] || echo ,interop)]" &&
    build/venv/bin/python -m pytest -q -p no:cacheprovider
}

export CTEST_PARALLEL_LEVEL=${CTEST_PARALLEL_LEVEL:-$(nproc)}

step install scripts/install_dependencies.sh || finish
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
step build configure_and_build release || finish
step tests ctest --preset release || true
step python python_package || true
step docs scripts/build_site.sh || true
step sanitize sanitized_tests || true
step program sanitized_program || true
if [[ $all == yes ]]; then
  step valgrind valgrind_program || true
  step threads threaded_tests || true
  step checks scripts/check.sh || true
else
  step checks scripts/check.sh --quick || true
fi
finish
