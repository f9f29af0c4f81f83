#!/usr/bin/env bash
# Fuzzes every reader of ours under libFuzzer, AddressSanitizer and UBSan, one target after the other, and tells what each has had. Corpus, log
# and whatever breaks a reader lie in build/fuzz/corpus, logs and found; build/fuzz/executions.tsv holds a line for each run. Both grow from
# call to call, so that a call goes on where the one before ended.
#   scripts/fuzz.sh                                      until every target has had 10 million executions
#   scripts/fuzz.sh [--runs N] [--seconds S] [NAME ...]  until N; no target longer than S seconds in this call; only those named
#   scripts/fuzz.sh --table                              tells what all have had until now
# Needs clang; installs the newest that this system has.
set -euo pipefail
cd "$(dirname "$0")/.."

fail() { echo "fuzz: $*" >&2; exit 2; }

runs=10000000 seconds=0 only=() table=no
while [[ $# -gt 0 ]]; do
  case $1 in
    --runs | --seconds)
      [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || fail "$1 is '${2:-}', but must be a whole number from 1."
      printf -v "${1#--}" %s "$2"
      shift
      ;;
    --table) table=yes ;;
    -*) fail "unknown option '$1'; say [--runs N] [--seconds S] [NAME ...], or --table." ;;
    *) only+=("$1") ;;
  esac
  shift
done

done_file=build/fuzz/executions.tsv  # target, executions, seconds, commit
mkdir -p build/fuzz/{corpus,logs,found}
touch "$done_file"
had() { awk -F'\t' -v target="$1" -v column="$2" '$1 == target { sum += $column } END { printf "%d", sum }' "$done_file"; }

if [[ $table == yes ]]; then
  printf '%-14s %12s %9s  %s\n' target executions seconds commits
  for target in $(cut -f1 "$done_file" | sort -u); do
    commits=$(awk -F'\t' -v target="$target" '$1 == target { print $4 }' "$done_file" | uniq | paste -sd' ')
    printf '%-14s %12d %9d  %s\n' "$target" "$(had "$target" 2)" "$(had "$target" 3)" "$commits"
  done
  exit
fi

scripts/install_dependencies.sh --fuzz
clang=$(compgen -c clang++- | grep -E '^clang\+\+-[0-9]+$' | sort -uV | tail -1)
command -v ccache >/dev/null && export CMAKE_CXX_COMPILER_LAUNCHER=ccache
cmake --preset fuzz -DCMAKE_CXX_COMPILER="$clang" >/dev/null
cmake --build --preset fuzz
fuzz=build/fuzz/tests/homolog_fuzz
commit=$(git describe --always --dirty 2>/dev/null || echo unknown)

mapfile -t targets < <("$fuzz" --targets)
for name in "${only[@]}"; do
  [[ " ${targets[*]} " == *" $name "* ]] || fail "there is no target '$name', but: ${targets[*]}."
done
[[ ${#only[@]} -eq 0 ]] || targets=("${only[@]}")

# A smaller store of freed memory stays in the cache, which makes twice as many executions of the same time; stacks that outlive their
# functions, watched by the unit tests, made three times as few.
export ASAN_OPTIONS=quarantine_size_mb=8:malloc_context_size=8:detect_stack_use_after_return=0:${ASAN_OPTIONS:-}
failed=no
printf '%-14s %12s %12s %8s %8s %8s  %s\n' target 'of all' 'in this call' seconds edges corpus result
for target in "${targets[@]}"; do
  left=$((runs - $(had "$target" 2)))
  [[ $left -gt 0 ]] || continue
  log=build/fuzz/logs/$target.log start=$SECONDS word="nothing found"
  "$fuzz" "--target=$target" "build/fuzz/corpus/$target" -runs="$left" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -malloc_limit_mb=512 -print_final_stats=1 -artifact_prefix="build/fuzz/found/$target-" >"$log" 2>&1 ||
    { word="FOUND: $(grep -m1 -E '^SUMMARY|^broken' "$log"), see $log"; failed=yes; }
  ran=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  printf '%s\t%d\t%d\t%s\n' "$target" "${ran:-0}" $((SECONDS - start)) "$commit" >>"$done_file"
  read -r edges corpus < <(sed -nE 's/.* cov: ([0-9]+) .* corp: ([0-9]+).*/\1 \2/p' "$log" | tail -1) || true
  printf '%-14s %12d %12d %8d %8s %8s  %s\n' "$target" "$(had "$target" 2)" "${ran:-0}" $((SECONDS - start)) "${edges:-?}" "${corpus:-?}" "$word"
done
[[ $failed == no ]]
