#!/usr/bin/env bash
# What tests cannot see: format, who includes whom, length of files, machine paths, paper map, commands in the docs, clang-tidy.
# Needs the release build (scripts/test.sh makes it) for the last two and says so when it is not there.
#   scripts/check.sh          all of it
#   scripts/check.sh --quick  without clang-tidy, in a second
set -euo pipefail
cd "$(dirname "$0")/.."

quick=no
case "${1:-}" in
  "") ;;
  --quick) quick=yes ;;
  *) echo "check: unknown option '$1'; the only one is --quick." >&2; exit 2 ;;
esac

failed=0
check() {
  local name=$1
  shift
  if "$@"; then echo "ok      $name"; else echo "FAILED  $name"; failed=$((failed + 1)); fi
}
leave_out() { echo "left out: $1 ($2)"; }

mapfile -t cpp < <(git ls-files -co --exclude-standard '*.h' '*.cpp')

# shellcheck disable=SC2317  # the functions are called through check
formatted() {
  local files
  files=$(clang-format-14 --dry-run -Werror "${cpp[@]}" 2>&1 | sed -n 's/^\([^:]*\):[0-9:]* error:.*/\1/p' | sort -u)
  [[ -z $files ]] || { echo "to be formatted by clang-format-14 -i:"; echo "$files"; return 1; }
}

# shellcheck disable=SC2317
files_are_short() {
  local long
  long=$(git ls-files -co --exclude-standard '*.h' '*.cpp' '*.py' '*.sh' '*.js' '*.mjs' '*.ts' '*.css' '*.html' |
    xargs wc -l | awk '$2 != "total" && $1 >= 300')
  [[ -z $long ]] || { echo "300 lines or more:"; echo "$long"; return 1; }
}

# A file must work on any machine: no path of one, no address of a package registry or mirror.
# shellcheck disable=SC2317
no_machine_paths() {
  ! git grep -nIE --untracked '(^|[^A-Za-z0-9._$}/-])/(home|root|work|Users|tmp/wt)/|https?://(registry|deb|archive|ftp|files|proxy|mirrors?)\.' \
    -- . ':!scripts/check.sh'
}

# bench/peers is built by its own script, against libraries that need not be here.
# shellcheck disable=SC2317
tidy() {
  mkdir -p build/tidy  # clang cannot read the headers that gcc has precompiled
  sed -E 's/ -Winvalid-pch//; s/ -include [^ ]*cmake_pch\.hxx//' build/release/compile_commands.json >build/tidy/compile_commands.json
  printf '%s\n' "${cpp[@]}" | grep -E '^(src|cli|bench|examples)/.*\.cpp$' | grep -v '^bench/peers/' |
    xargs -P "$(nproc)" -n 1 "$clang_tidy" -p build/tidy --quiet >build/tidy.log 2>/dev/null && return
  cat build/tidy.log
  return 1
}

if command -v clang-format-14 >/dev/null; then
  check "format" formatted
else
  leave_out "format" "no clang-format-14"
fi
check "include rules" scripts/check_includes.py
check "file lengths" files_are_short
check "no machine paths" no_machine_paths
check "paper map" scripts/check_paper_map.py

if [[ -x build/release/cli/homolog ]]; then
  check "commands in the docs" scripts/check_docs.py build/release/cli/homolog
else
  leave_out "commands in the docs" "no build/release/cli/homolog"
fi

clang_tidy=
for version in 16 17 18 19 20; do
  if command -v "clang-tidy-$version" >/dev/null; then clang_tidy=clang-tidy-$version; break; fi
done
if [[ $quick == yes ]]; then
  leave_out "clang-tidy" "--quick"
elif [[ -n $clang_tidy && -f build/release/compile_commands.json ]]; then
  check "$clang_tidy" tidy
else
  leave_out "clang-tidy" "needs clang-tidy 16 or newer and build/release/compile_commands.json"
fi

[[ $failed -eq 0 ]]
