# SPDX-License-Identifier: MIT
"""Finds the corresponding parts of two 3D shapes.

Everywhere a shape is a path, a pair (vertices, faces) of arrays (n, 3) and (m, 3), a mesh with .vertices and .faces (trimesh) or
.vertices and .triangles (Open3D), a PyVista mesh, or what `describe` made. Parameters are keywords, those of `homolog params` with
underscores; `parameters()` lists them. Besides, `preset` is "default" or "paper", and `threads` bounds the threads (0: all cores), which
changes no byte of a result.

A part is a box ((x, y, z), (x, y, z)) in shares of the shape's bounding box, 0 to 1: part=((0, 0.5, 0), (1, 1, 1)) is the upper half in y.

Of a label volume, `label` says which voxels are the shape: those of this value, 0 for all that are not 0.

Bad shapes and parameters raise ValueError, files that cannot be read OSError.
"""
from __future__ import annotations

from copy import copy
from typing import TYPE_CHECKING, Any

from homolog import _core
from homolog._core import __version__
from homolog.dense import Dense, DenseMap, Morph
from homolog.landmarks import Carried, Landmarks, read_landmarks, write_landmarks
from homolog.results import Family, Match, Points, Symmetry, ThinPlateSpline, family_of
from homolog.shapes import Shape, surface_of, texts_of
from homolog.stored import load

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from homolog.parameters import Parameters

__all__ = [
    "Carried", "Dense", "DenseMap", "Family", "Landmarks", "Match", "Morph", "Points", "Shape", "Symmetry", "ThinPlateSpline", "__version__",
    "describe", "load", "match", "parameters", "points", "read_landmarks", "symmetry", "write_landmarks",
]  # fmt: skip


def describe(
    shape: Any,
    *,
    part: Any = None,
    label: int | None = None,
    max_bytes: int | None = None,
    max_triangles: int | None = None,
    max_voxels: int | None = None,
    **parameters: Unpack[Parameters],
) -> Shape:
    """Describes a shape, or a part of it, so that many calls can use it. A file beyond the limits raises OSError."""
    given = {"bytes": max_bytes, "triangles": max_triangles, "voxels": max_voxels}
    most = {what: number for what, number in given.items() if number is not None}
    for what, number in most.items():
        if not isinstance(number, int) or number < 1:
            raise ValueError(f"max_{what} is {number!r}, but must be a whole number from 1")
    return Shape(surface_of(shape, label, most), part, texts_of(parameters))


def _described(shape: Any, part: Any, label: int | None, parameters: dict[str, str]) -> Shape:
    if not isinstance(shape, Shape):
        return Shape(surface_of(shape, label), part, parameters)
    if part is not None or label is not None:
        raise ValueError("a described shape has its part and its label already; give them to homolog.describe")
    return shape


def _with_those_of(shapes: tuple[Any, ...], parameters: Parameters) -> dict[str, str]:
    """The parameters given, on top of those that the described shapes have."""
    texts: dict[str, str] = {}
    for shape in shapes:
        if isinstance(shape, Shape):
            texts.update(shape.parameters)
    return {**texts, **texts_of(parameters)}


def points(shape: Any, *, part: Any = None, label: int | None = None, **parameters: Unpack[Parameters]) -> Points:
    """The salient points of a shape. Those of a described one are known already, so that it takes no parameters."""
    if isinstance(shape, Shape) and parameters:
        raise ValueError("a described shape has its points already; give the parameters to homolog.describe")
    return _described(shape, part, label, texts_of(parameters)).points


def match(
    model: Any,
    data: Any,
    *,
    model_part: Any = None,
    data_part: Any = None,
    model_label: int | None = None,
    data_label: int | None = None,
    **parameters: Unpack[Parameters],
) -> Family:
    """Every place where the model, or a part of it, occurs in the data, best first."""
    texts = _with_those_of((model, data), parameters)
    model, data = _described(model, model_part, model_label, texts), _described(data, data_part, data_label, texts)
    return family_of(_core.match(model._described, data._described, texts), copy(model), copy(data))


def symmetry(shape: Any, *, part: Any = None, label: int | None = None, **parameters: Unpack[Parameters]) -> Family:
    """A shape against itself: its symmetries and repeated parts, the identity left out. What each one says stands in `symmetries`."""
    texts = _with_those_of((shape,), parameters)
    shape = _described(shape, part, label, texts)
    return family_of(_core.symmetry(shape._described, texts), copy(shape), copy(shape))


def parameters() -> list[dict[str, Any]]:
    """The table of parameters: name, sentence, unit, default and range (least and most, or the choices)."""
    return [{**row, "name": row["name"].replace("-", "_")} for row in _core.parameters()]


def _parameter_text() -> str:
    lines = [f"    {row['name']}={row['default']!r}: {row['sentence']}" for row in parameters()]
    return "\n\n    Parameters, with their defaults:\n\n" + "\n".join(lines)


for _function in (describe, points, match, symmetry):
    _function.__doc__ = (_function.__doc__ or "") + _parameter_text()
del _function
