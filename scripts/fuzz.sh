#!/usr/bin/env bash
# Fuzzes every reader of ours under libFuzzer, AddressSanitizer and UBSan, one target after the other, and tells what each ran. Corpus, log
# and whatever breaks a reader lie in build/fuzz/corpus, logs and found; a corpus grows from run to run.
#   scripts/fuzz.sh                  10 million runs of every target
#   scripts/fuzz.sh --runs N [NAME]  N runs of every target, or of the one called NAME
# Needs clang; installs the newest that this system has.
set -euo pipefail
cd "$(dirname "$0")/.."

fail() { echo "fuzz: $*" >&2; exit 2; }

runs=10000000
if [[ ${1:-} == --runs ]]; then
  runs=${2:-}
  [[ $runs =~ ^[1-9][0-9]*$ ]] || fail "--runs is '$runs', but must be a whole number from 1."
  shift 2
fi
only=${1:-}
[[ $only != -* && $# -le 1 ]] || fail "unknown option '$*'; say [--runs N] [NAME]."

scripts/install_dependencies.sh --fuzz
clang=$(compgen -c clang++- | grep -E '^clang\+\+-[0-9]+$' | sort -uV | tail -1)
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake --preset fuzz -DCMAKE_CXX_COMPILER="$clang" >/dev/null
cmake --build --preset fuzz
fuzz=build/fuzz/tests/homolog_fuzz

targets=$("$fuzz" --targets)
[[ -z $only ]] || targets=$(grep -x "$only" <<<"$targets") || fail "there is no target '$only', but: ${targets//$'\n'/, }."
mkdir -p build/fuzz/{corpus,logs,found}

failed=no
printf '%-12s %12s %8s %8s %8s  %s\n' target runs seconds edges corpus result
for target in $targets; do
  log=build/fuzz/logs/$target.log start=$SECONDS word="nothing found"
  "$fuzz" "--target=$target" "build/fuzz/corpus/$target" -runs="$runs" -max_len=2000 -timeout=10 -rss_limit_mb=2048 -malloc_limit_mb=512 \
    -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target-" >"$log" 2>&1 ||
    { word="FOUND: $(grep -m1 -E '^SUMMARY|^broken' "$log"), see $log"; failed=yes; }
  ran=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  read -r edges corpus < <(sed -nE 's/.* cov: ([0-9]+) .* corp: ([0-9]+).*/\1 \2/p' "$log" | tail -1) || true
  printf '%-12s %12s %8d %8s %8s  %s\n' "$target" "${ran:-?}" $((SECONDS - start)) "${edges:-?}" "${corpus:-?}" "$word"
done
[[ $failed == no ]]
