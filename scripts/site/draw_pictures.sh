#!/usr/bin/env bash
# Draws the pictures of the documentation site into build/site/pictures, from what the pages' own commands left in build/site/runs.
set -euo pipefail
cd "$(dirname "$0")/../.."

runs=build/site/runs pictures=build/site/pictures examples=build/release/examples
rm -rf "$pictures" && mkdir -p "$pictures"
[[ -d viewer/node_modules/playwright-core ]] || (cd viewer && npm ci --silent)
node viewer/picture.mjs "$runs/tutorial/bears/report.html" "$pictures/tutorial_report.png"
"$examples/example_02_stages" "$runs/tutorial/bear.off" build/site/slice.pgm >/dev/null
"$examples/example_03_match_stages" "$runs/tutorial/bear.off" "$runs/tutorial/bear_bis.off" >build/site/stages.csv
build/venv/bin/python scripts/site/draw_pictures.py "$runs" "$pictures" build/site/slice.pgm build/site/stages.csv 2>build/site/pictures.log ||
  { cat build/site/pictures.log >&2; exit 1; }
