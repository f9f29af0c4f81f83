# SPDX-License-Identifier: MIT
"""From whatever holds a shape to a described one."""
from __future__ import annotations

import difflib
import os
import sys
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from homolog import _core
from homolog.files import told_if_missing
from homolog.results import Points
from homolog.tables import html_table


class Surface(NamedTuple):
    """What is known of a shape before it is described."""

    vertices: np.ndarray  # (n, 3)
    faces: np.ndarray  # (m, 3)
    name: str
    ras: bool


def surface_of(shape: Any, label: int | None = None, most: dict[str, int] | None = None) -> Surface:
    """The surface of anything that `describe` takes; of a file with its label, and no more than `most`."""
    if isinstance(shape, (str, bytes, os.PathLike)):
        return _read(Path(os.fsdecode(shape)), label, most or {})
    if label is not None or most:
        raise ValueError("a label and limits go with the path of a file, but this shape is in memory already")
    if hasattr(shape, "to_mesh") and not hasattr(shape, "faces"):  # a scene of trimesh
        shape = shape.to_mesh()
    if hasattr(shape, "triangulate") and hasattr(shape, "points"):  # PyVista
        surface = _surface_of(shape).triangulate()
        vertices, faces = surface.points, np.asarray(surface.faces).reshape(-1, 4)[:, 1:]
    elif hasattr(shape, "vertices") and hasattr(shape, "faces"):  # trimesh and its like
        vertices, faces = shape.vertices, shape.faces
    elif hasattr(shape, "vertices") and hasattr(shape, "triangles"):  # Open3D
        vertices, faces = np.asarray(shape.vertices), np.asarray(shape.triangles)
    elif isinstance(shape, (tuple, list)) and len(shape) == 2:
        vertices, faces = shape
    else:
        kind = type(shape).__name__
        raise ValueError(f"a {kind} is no shape; give a path, (vertices, faces), or a mesh with .vertices and .faces")
    return Surface(_rows(vertices, "vertices", np.float64), _rows(faces, "faces", np.uint32), "", False)


def _surface_of(mesh: Any) -> Any:
    if hasattr(mesh, "faces"):
        return mesh
    with warnings.catch_warnings():  # by which algorithm one day makes no difference here
        warnings.simplefilter("ignore")
        return mesh.extract_surface()


def _read(path: Path, label: int | None, most: dict[str, int]) -> Surface:
    with told_if_missing(path):
        vertices, faces, ras, told = _core.read(path, label, most)
    for sentence in told:
        warnings.warn(f"{path.name}: {sentence}", UserWarning, stacklevel=_callers_level())
    return Surface(vertices, faces, path.name, ras)


def _callers_level() -> int:
    """How many calls above the one that asks the first lies which is not in this package."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and Path(frame.f_code.co_filename).parent == Path(__file__).parent:
        frame, level = frame.f_back, level + 1
    return level


def _rows(rows: Any, what: str, dtype: type) -> np.ndarray:
    """An (n, 3) array of the type. Throws ValueError."""
    try:
        rows = np.asarray(rows)
    except ValueError as error:
        raise ValueError(f"the {what} are no array: {error}") from None
    if rows.ndim != 2 or rows.shape[1] != 3:
        hint = "; divide polygons into triangles first" if what == "faces" and rows.ndim == 2 else ""
        raise ValueError(f"the {what} have the shape {rows.shape}, but must have (n, 3){hint}")
    integer = dtype is np.uint32
    if rows.dtype.kind not in ("iu" if integer else "fiu"):
        raise ValueError(f"the {what} are of type {rows.dtype}, but must be {'integers' if integer else 'real numbers'}")
    if integer and rows.size and not 0 <= rows.min() <= rows.max() < 2**32:
        raise ValueError(f"the {what} name the vertex {rows.min() if rows.min() < 0 else rows.max()}, which cannot be")
    return np.array(rows, dtype, order="C")  # a copy: the caller's may change


def _corners(part: Any) -> np.ndarray | None:
    try:
        corners = None if part is None else np.asarray(part, np.float64)
    except (TypeError, ValueError):
        corners = np.empty(0)
    if corners is not None and corners.shape != (2, 3):
        raise ValueError(f"the part is {part!r}, but must be a box ((x, y, z), (x, y, z)) in shares from 0 to 1")
    return corners


def texts_of(parameters: Mapping[str, Any]) -> dict[str, str]:
    """Parameters by their name in the table. Throws ValueError for an unknown name."""
    known = [row["name"] for row in _core.parameters()] + ["preset", "threads"]
    texts = {name.replace("_", "-"): str(value) for name, value in parameters.items()}
    for name in texts:
        if name not in known:
            near = difflib.get_close_matches(name, known, n=1)
            hint = f"did you mean '{near[0].replace('-', '_')}'?" if near else "homolog.parameters() lists all"
            raise ValueError(f"unknown parameter '{name.replace('-', '_')}'; {hint}")
    return texts


class Shape:
    """A described shape, made by `homolog.describe`: describing once serves many matches.

    Copies and pickles leave the description out, which is large; it is made again where it is needed.
    """

    vertices: np.ndarray  #: (n, 3)
    faces: np.ndarray  #: (m, 3), triangles
    name: str  #: of the file, if there was one
    ras: bool  #: whether the file states RAS, as 3D Slicer writes it; else its coordinates are taken for LPS, where that matters
    points: Points  #: the salient points
    diagonal: float  #: of the bounding box of the part in use, in the shape's own units
    guessed: float  #: share of the volume that had to be guessed, because the mesh is open: 0 to 1; NaN if it is not known, of homolog.load

    def __init__(self, surface: Surface, part: Any, parameters: dict[str, str], told: dict[str, Any] | None = None):
        """`told`: points and diagonal of one that was described before; its mesh may be empty then."""
        self.vertices, self.faces, self.name, self.ras = surface
        self.part, self.parameters = part, parameters
        self._made: _core.Described | None = None
        self._told = told is not None
        if told is None:
            told = {"points": self._described.points, "diagonal": self._described.diagonal, "guessed": self._described.guessed}
        self.points, self.diagonal, self.guessed = Points(**told["points"]), told["diagonal"], told.get("guessed", np.nan)

    @property
    def _described(self) -> _core.Described:
        if self._made is None:
            self.require_mesh()
            made = _core.describe(self.vertices, self.faces, self.name, self.ras, _corners(self.part), self.parameters)
            if self._told and made.diagonal != self.diagonal:
                raise ValueError(f"a part of '{self.name}' was matched, and match.json does not tell which; describe it again with its part")
            self._made = made
        return self._made

    def require_mesh(self) -> None:
        """Throws ValueError if the mesh is not known."""
        if self._told and not len(self.faces):
            raise ValueError(f"the mesh of '{self.name}' does not lie beside the match.json; give it to homolog.load")

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_made": None}

    def __repr__(self) -> str:
        name = f"'{self.name}', " if self.name else ""
        return f"<homolog.Shape: {name}{len(self.faces)} faces, {len(self.points)} salient points, diagonal {self.diagonal:.4g}>"

    def _repr_html_(self) -> str:
        counts = map(str, (len(self.vertices), len(self.faces), len(self.points)))
        heads = ["shape", "vertices", "faces", "salient points", "diagonal", "guessed"]
        return html_table(heads, [[self.name, *counts, f"{self.diagonal:.4g}", f"{self.guessed:.2%}"]])
