#!/usr/bin/env bash
# Draws the pictures of the documentation site into build/site/pictures, from what the pages' own commands left in build/site/runs.
#   scripts/site/draw_pictures.sh           all of them
#   scripts/site/draw_pictures.sh --readme  the one of the README alone, into docs, where it is kept
set -euo pipefail
cd "$(dirname "$0")/../.."

runs=build/site/runs pictures=build/site/pictures examples=build/release/examples
[[ -d viewer/node_modules/playwright-core ]] || (cd viewer && npm ci --silent)
case "${1:-}" in
  "") ;;
  --readme) exec node viewer/picture.mjs "$runs/tutorial/upper/report.html" docs/demo.png ;;
  *) echo "draw_pictures: unknown option '$1'; the only one is --readme." >&2; exit 2 ;;
esac
rm -rf "$pictures" && mkdir -p "$pictures"
node viewer/picture.mjs "$runs/tutorial/bears/report.html" "$pictures/tutorial_report.png"
node viewer/picture.mjs "$runs/tutorial/upper/report.html" "$pictures/tutorial_upper.png"
"$examples/example_02_stages" "$runs/tutorial/bear.off" build/site/slice.pgm >/dev/null
"$examples/example_03_match_stages" "$runs/tutorial/bear.off" "$runs/tutorial/bear_bis.off" >build/site/stages.csv
build/venv/bin/python scripts/site/draw_pictures.py "$runs" "$pictures" build/site/slice.pgm build/site/stages.csv 2>build/site/pictures.log ||
  { cat build/site/pictures.log >&2; exit 1; }
