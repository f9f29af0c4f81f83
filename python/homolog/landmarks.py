# SPDX-License-Identifier: MIT
"""Named points: from files, carried by a match, and to files."""
from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from homolog import _core
from homolog.files import told_if_missing
from homolog.tables import html_table, mean_of


@dataclass(frozen=True, eq=False, repr=False)
class Landmarks:
    """The n points of a landmark file, in its order."""

    labels: tuple[str, ...]
    position: np.ndarray  #: (n, 3); NaN where a landmark is missing

    def __len__(self) -> int:
        return len(self.labels)

    @property
    def there(self) -> np.ndarray:
        """(n,) of bool: which are not missing."""
        there: np.ndarray = np.isfinite(self.position).all(axis=1)
        return there

    def __repr__(self) -> str:
        return f"<homolog.Landmarks: {len(self)}, {np.count_nonzero(~self.there)} of them missing>"

    def _repr_html_(self) -> str:
        rows = ([name, *(f"{x:.4g}" for x in place)] if there else [name, "", "", ""] for name, place, there in self._rows())
        return html_table(["label", "x", "y", "z"], rows)

    def _rows(self) -> zip[tuple[str, np.ndarray, bool]]:
        return zip(self.labels, self.position, self.there)


@dataclass(frozen=True, eq=False, repr=False)
class Carried:
    """Points carried to the other shape, each with how far it can be trusted."""

    position: np.ndarray  #: (n, 3), where the map puts them; NaN of points that were missing already
    there: np.ndarray  #: (n,) of bool; false: outside the covered part, thus missing on the other shape, whatever `position` says
    expected_error: np.ndarray  #: (n,), true errors are larger as often as smaller if the match is right; unit of the shape carried to
    coverage: np.ndarray  #: (n,), how surely each lies in the covered part, 0 to 1

    def __repr__(self) -> str:
        return f"<homolog.Carried: {np.count_nonzero(self.there)} of {self.there.size} points there>"

    def _repr_html_(self) -> str:
        means = [mean_of(self.expected_error, self.there), mean_of(self.coverage, self.there)]
        heads = ["points", "there", "mean expected error", "mean coverage"]
        return html_table(heads, [[str(self.there.size), str(np.count_nonzero(self.there)), *means]])


def read_landmarks(path: str | os.PathLike[str], *, specimen: str | int = "", ras: bool = False) -> Landmarks:
    """The landmarks of a file: .csv, .mrk.json or .fcsv of 3D Slicer, .tps, .pts of Landmark Editor, .txt of Morphologika.

    `specimen`: which one of a .tps or .txt that holds several, by its name or its number from 1. Points of 3D Slicer come in LPS, whatever
    the file states, or in RAS if `ras`: give that of the shape that they belong to (`Shape.ras`). Throws OSError, naming the line.
    """
    with told_if_missing(Path(path)):
        labels, position = _core.read_landmarks(Path(path), str(specimen), ras)
    return Landmarks(tuple(labels), position)


def write_landmarks(
    path: str | os.PathLike[str], points: Any, labels: Iterable[str] | None = None, *, name: str | None = None, ras: bool = False
) -> None:
    """Writes points as .csv, .mrk.json, .tps, .pts (Landmark Editor) or .txt (Morphologika), by the ending of the path.

    `points` are Landmarks, (n, 3) where NaN is missing, or Carried ones: those that are not there are missing, and .csv and .mrk.json tell
    the errors to expect. `labels`: their names, those of Landmarks if they have none of their own. `name`: of the specimen, in .tps and
    .txt, else the name of the file. `ras`: what a .mrk.json states, that of the shape. Throws OSError if the file cannot be written.
    """
    position = np.asarray(points.position if isinstance(points, (Landmarks, Carried)) else points, np.float64)
    if position.ndim != 2 or position.shape[1] != 3:
        raise ValueError(f"the points have the shape {position.shape}, but must have (n, 3)")
    names = list(labels) if labels is not None else list(points.labels) if isinstance(points, Landmarks) else [""] * len(position)
    if len(names) != len(position):
        raise ValueError(f"there are {len(names)} labels, but {len(position)} points")
    path = Path(path)
    of = (path.name.split(".")[0] if name is None else name, ras)
    if isinstance(points, Carried):
        _core.write_carried(path, names, position, points.there.tolist(), points.expected_error, points.coverage, *of)
    else:
        _core.write_landmarks(path, names, position, *of)
