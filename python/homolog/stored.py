# SPDX-License-Identifier: MIT
"""Families from the folders that `homolog match --out` and Family.save write."""
from __future__ import annotations

import os
import warnings
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from homolog import _core
from homolog.files import told_if_missing
from homolog.results import Family, family_of
from homolog.shapes import Shape, Surface, surface_of


def load(path: str | os.PathLike[str], *, model: Any = None, data: Any = None) -> Family:
    """The family in a match.json, or in the folder that `homolog match --out` or Family.save wrote.

    It carries points and what is on the meshes as when it was found. The meshes are those beside the match.json unless `model` and `data`,
    in any form that `describe` takes, say which were matched. The file does not tell all: `followed` is empty, for such points stand among
    those of the data, and a part has to be named again to match the shape anew. Throws OSError for files that cannot be read.
    """
    path = Path(path)
    file = path / "match.json" if path.is_dir() else path
    with told_if_missing(file):
        fields, of_model, of_data, parameters, parts_known = _core.load(file)
    if not parts_known:
        warnings.warn(f"no parts.json lies beside {file}, so points outside the covered part are carried, too", UserWarning, stacklevel=2)
    family = family_of(fields, _shape(model, "model", of_model, file, parameters), _shape(data, "data", of_data, file, parameters))
    return _with_parts(family, parts_known, file)


def _shape(given: Any, side: str, told: dict[str, Any], file: Path, parameters: dict[str, str]) -> Shape:
    beside = file.with_name(f"{side}.part.ply")
    if given is None and beside.exists():
        given = beside
    vertices, faces = (np.empty((0, 3)), np.empty((0, 3), np.uint32)) if given is None else _mesh(given)
    return Shape(Surface(vertices, faces, told["name"], told["ras"]), None, parameters, told)


def _mesh(given: Any) -> tuple[np.ndarray, np.ndarray]:
    return (given.vertices, given.faces) if isinstance(given, Shape) else surface_of(given)[:2]


def _with_parts(family: Family, known: bool, file: Path) -> Family:
    """The meshes have the vertices that were matched; without a parts.json nothing is known of these."""
    sides = (("model", family.model), ("data", family.data))
    if not known:
        unknown: dict[str, Any] = {f"{side}_part": np.full(len(shape.vertices), np.nan, np.float32) for side, shape in sides}
        return replace(family, matches=tuple(replace(match, **unknown) for match in family.matches))
    for side, shape in sides:
        had = {len(getattr(match, f"{side}_part")) for match in family.matches}
        if len(shape.faces) and had - {len(shape.vertices)}:
            raise ValueError(
                f"the mesh has {len(shape.vertices)} vertices, but the {side} of {file} had {had.pop()}; name that mesh in homolog.load"
            )
    return family
