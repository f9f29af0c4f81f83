#!/usr/bin/env bash
# The documentation site, into build/site/html: runs every command of its pages (tests/docs/run_blocks.py), draws the pictures from what they
# made, and lets MkDocs put the pages together. Needs the release build, and the Python package in build/venv; scripts/test.sh makes both.
#   scripts/build_site.sh          all of it
#   scripts/build_site.sh --pages  the pages alone, with outputs and pictures as they were
set -euo pipefail
cd "$(dirname "$0")/.."

fail() { echo "build_site: $*" >&2; exit 2; }

pages_only=no
case "${1:-}" in
  "") ;;
  --pages) pages_only=yes ;;
  *) fail "unknown option '$1'; the only one is --pages." ;;
esac

export HOMOLOG=build/release/cli/homolog HOMOLOG_PYTHON=build/venv/bin/python
[[ -x $HOMOLOG && -x $HOMOLOG_PYTHON ]] || fail "there is no $HOMOLOG or no $HOMOLOG_PYTHON; scripts/test.sh makes both."
if [[ $pages_only == no ]]; then
  "$HOMOLOG_PYTHON" tests/docs/run_blocks.py "$HOMOLOG" --keep build/site/runs
  scripts/site/draw_pictures.sh
fi

[[ -d build/site_venv ]] || python3 -m venv build/site_venv
build/site_venv/bin/pip install -q --disable-pip-version-check -r scripts/site/requirements.txt
npm install --silent --no-audit --no-fund --prefix build/site/npm iframe-worker@1.0.3  # lets the search work without a server
build/site_venv/bin/mkdocs build --quiet --strict
scripts/site/check_offline.py build/site/html
echo "The site is $PWD/build/site/html/index.html"
