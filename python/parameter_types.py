# SPDX-License-Identifier: MIT
"""Writes parameters.pyi, the types of all parameters as keywords, from the library's own table: parameter_types.py FOLDER OUT

FOLDER holds the module _core. Type checkers and editors read what comes out; at run time nobody does.
"""
import sys
from pathlib import Path

sys.path.insert(0, sys.argv[1])
import _core  # noqa: E402


def type_of(row):
    if isinstance(row["default"], str):
        return f"Literal[{', '.join(map(repr, row['range']))}]"
    return type(row["default"]).__name__


rows = [(row["name"].replace("-", "_"), type_of(row), row["sentence"]) for row in _core.parameters()]
rows += [("preset", "Literal['default', 'paper']", "All other parameters at once."), ("threads", "int", "At most this many; 0: all cores.")]
lines = ["from typing import Literal, TypedDict", "", "class Parameters(TypedDict, total=False):"]
for name, kind, sentence in rows:
    lines += [f"    {name}: {kind}", f"    {sentence!r}"]
Path(sys.argv[2]).write_text("\n".join(lines) + "\n", encoding="utf-8")
