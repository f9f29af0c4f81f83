#!/usr/bin/env bash
# What every parameter of the default would cost if it were otherwise: a line for the default, then one for each parameter with a lower and
# a higher value, on every sixth pair of a folder; some 20 minutes on two cores. Progress goes to stderr, rows to build/parameters.
#   bench/parameter_reasons.sh FOLDER      FOLDER: pairs.tsv, its shapes and truth (bench/README.md)
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(realpath -e "${1:?parameter_reasons: give the folder of pairs.tsv}") rows=build/parameters
rm -rf "$rows/few"
mkdir -p "$rows/few"
ln -s "$folder"/*/ "$rows/few/"
awk 'NR % 6 == 1' "$folder/pairs.tsv" >"$rows/few/pairs.tsv"

others=(
  resolution={160,320} thicken=0.005 sigma0={1.2,2.2} levels-per-octave={2,5} threshold={0.38,0.52} direction-radius={1.4,3} direction-min={0.05,0.25}
  descriptor=axial shells=linear shell-count={5,12} degree={5,12} inner={0.35,0.7} outer={5,12} searched-points={50,200} partners={5,20}
  bending={0.006,0.04} mirror=forbid seeds=quadruples
)
failed=0  # a pair in error must not stop the rest
printf '%-22s %5s %6s %6s %6s %9s %9s %6s\n' "$(git describe --always --dirty)" right 'in six' direct share transfer mean 'CPU s'
for other in default "${others[@]}"; do
  echo "parameter_reasons: $other" >&2
  param=(--param "$other")
  [[ $other != default ]] || param=()
  build/release/bench/bench_accuracy "$rows/few" "${param[@]}" --rows "$rows/$other.tsv" |
    awk -v name="$other" '$1 == "all" { printf "%-22s %5.0f %6s %6s %6s %9s %9s %6s\n", name, $2 * $4, $5, $6, $7, $9, $10, $14 }' || failed=1
done
exit "$failed"
