#!/usr/bin/env bash
# Measures all of docs/accuracy.md in one run and prints docs/accuracy_output.md; some two hours on two cores. Rows of every run lie in
# build/accuracy. Progress goes to stderr.
#   bench/measure_accuracy.sh FOLDER >docs/accuracy_output.md      FOLDER: pairs.tsv, its shapes and truth (bench/README.md)
#   bench/measure_accuracy.sh FOLDER 'Dense|Carried'               only the sections whose titles match
set -euo pipefail
cd "$(dirname "$0")/.."

folder=$(realpath -e "${1:?measure_accuracy: give the folder of pairs.tsv}")
only=${2:-.} bench=build/release/bench rows=build/accuracy
failed=0  # a pair in error must not stop the rest
mkdir -p "$rows"

# Every second whole model of the list, once, is what cases are made of.
mapfile -t models < <(awk -F'\t' '$1 == "whole" { print $2 }' "$folder/pairs.tsv" | sort -t/ -uk2,2 | awk 'NR % 2')
meshes=()
for model in "${models[@]}"; do meshes+=(--mesh "$folder/$model.off"); done
named=$(printf '%s, ' "${models[@]}")

# told TITLE COMMAND...: the command, and what it printed but for its rows a pair.
told() {
  local title=$1 shown
  shift
  [[ $title =~ $only ]] || return 0
  echo "measure_accuracy: $title" >&2
  shown=$(sed -E "s|( --mesh [^ ]+)+| --mesh MESH...|; s|$folder|FOLDER|g; s|$rows/||g; s|$bench/||g" <<<"$*")
  printf '\n## %s\n\n`%s`\n\n```\n' "$title" "$shown"
  "$@" | sed '/^task  *model/,/^$/d' || failed=1
  printf '```\n'
}
accuracy() { local title=$1 name=$2; shift 2; told "$title" "$bench/bench_accuracy" "$@" --rows "$rows/$name.tsv"; }

echo "# What the accuracy benches printed"
echo
echo "The numbers of [How right it is](accuracy.md) come from this run, \`bench/measure_accuracy.sh FOLDER\`; \`bench/README.md\` explains every column."
echo "At $(git describe --always --dirty), $(sed -n 's/^model name\s*: //p' /proc/cpuinfo | head -1), $(nproc) cores. FOLDER is the public list's."
echo "MESH are, besides three made in code, ${named%, }."
accuracy "The public list" public "$folder"
accuracy "The paper's choices on it" paper "$folder" --preset paper
accuracy "The public list turned, scaled and moved otherwise" turned "$folder" --turn 7
told "How much that changes" bench/compare_rows.py "$rows/public.tsv" "$rows/turned.tsv"
accuracy "The public list with its models turned, scaled and moved, too" model_turned "$folder" --turn-model 7
told "How much that changes besides" bench/compare_rows.py "$rows/public.tsv" "$rows/model_turned.tsv"
python3 bench/more_pairs.py "$folder" "$rows/more" >&2
accuracy "Other pairs of the same shapes, and pairs that share nothing" more "$rows/more"
python3 -m venv "$rows/venv"
"$rows/venv/bin/pip" -q --disable-pip-version-check install numpy scikit-image >&2
"$rows/venv/bin/python" bench/kinds.py "$rows/kinds" 1 >&2
accuracy "Other kinds, made by chance" kinds "$rows/kinds"
for task in whole mirror part scene; do
  accuracy "Generated cases: $task" "generated_$task" --generate "${meshes[@]}" --only "$task"
done
accuracy "Generated cases by the paper's choices" paper_generated --generate "${meshes[@]}" --preset paper
accuracy "Generated cases: heaps of pieces that share nothing" strangers --generate "${meshes[@]}" --only unrelated --strangers 15
told "Carried points" "$bench/bench_transfer" "$folder"
told "Dense maps" "$bench/bench_dense" "$folder"
told "Every parameter otherwise" bench/parameter_reasons.sh "$folder"
exit "$failed"
