# SPDX-License-Identifier: MIT
"""Every vertex of either mesh on the other one: what `Family.dense` and `Family.morph` return. All of it pickles."""
from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from homolog import _core
from homolog.tables import html_table, mean_of

if TYPE_CHECKING:
    from homolog.shapes import Shape


_HEADS = ["mean confidence", "vertices", "with a place", "torn edges", "triangles", "folded"]


@dataclass(frozen=True, eq=False, repr=False)
class DenseMap:
    """For each of the n vertices of one mesh its place on the other one."""

    triangle: np.ndarray  #: (n,), of the other mesh's faces; -1: no place, outside the covered part or torn away from its neighbours
    barycentric: np.ndarray  #: (n, 3), shares of the triangle's corners, sum 1; NaN without a place
    position: np.ndarray  #: (n, 3), in the other mesh's coordinates; NaN without a place
    confidence: np.ndarray  #: (n,), that it is right within .05 of the matched extent, if the match is right; 0 to 1
    torn: int  #: edges whose ends came to lie far apart, so that one end of each lost its place
    triangles: int  #: of this mesh, those with three places
    folded: int  #: of these, those that lie there with the wrong side up

    @property
    def there(self) -> np.ndarray:
        """(n,) of bool: which vertices have a place."""
        return self.triangle >= 0

    def __repr__(self) -> str:
        return f"<homolog.DenseMap: {np.count_nonzero(self.there)} of {len(self.triangle)} vertices have a place>"

    def _row(self) -> list[str]:
        counts = (len(self.triangle), np.count_nonzero(self.there), self.torn, self.triangles, self.folded)
        return [mean_of(self.confidence, self.there), *map(str, counts)]

    def _repr_html_(self) -> str:
        return html_table(_HEADS, [self._row()])


@dataclass(frozen=True, eq=False, repr=False)
class Dense:
    """Both directions of a dense map."""

    data_from_model: DenseMap  #: of the model's vertices, on the data
    model_from_data: DenseMap  #: of the data's vertices, on the model
    model: Shape
    data: Shape

    def carry_to_data(self, values: Any, *, labels: bool = False) -> np.ndarray:
        """What the model's n vertices have, (n,) or (n, k), at the m vertices of the data, (m,) or (m, k).

        Values, such as colours, weights or a depth, lie between those of the corners of a place's triangle. Labels, such as the numbers of
        parts, do not: each is that of the largest share, so none comes up that was not there. Without a place, or where most of the triangle
        has no value, NaN. Throws ValueError for another number of vertices.
        """
        return _carried(values, labels, self.model, self.model_from_data)

    def carry_to_model(self, values: Any, *, labels: bool = False) -> np.ndarray:
        """The same from the data's vertices to the model's."""
        return _carried(values, labels, self.data, self.data_from_model)

    def __repr__(self) -> str:
        return f"<homolog.Dense: data_from_model {self.data_from_model!r}, model_from_data {self.model_from_data!r}>"

    def _repr_html_(self) -> str:
        rows = (["data_from_model", *self.data_from_model._row()], ["model_from_data", *self.model_from_data._row()])
        return html_table(["", *_HEADS], rows)


def _carried(values: Any, labels: bool, giver: Shape, places: DenseMap) -> np.ndarray:
    table = np.asarray(values)
    if table.dtype.kind not in "biuf" or table.ndim not in (1, 2) or len(table) != len(giver.vertices):
        count = len(giver.vertices)
        raise ValueError(f"the values are of type {table.dtype} and shape {table.shape}, but must be numbers, ({count},) or ({count}, k)")
    columns = table.astype(np.float64).reshape(len(table), -1)
    carried = _core.between(places.triangle, np.nan_to_num(places.barycentric), giver.faces, columns, labels)
    return carried.reshape(len(carried), *table.shape[1:])


@dataclass(frozen=True, eq=False, repr=False)
class Morph:
    """The model's mesh in two shapes, both in the data's coordinates: it turns into the data."""

    start: np.ndarray  #: (n, 3), the model, laid over the data by the similarity of the match
    end: np.ndarray  #: (n, 3), the same vertices on the data, smoothly continued where they have no place there
    faces: np.ndarray  #: (m, 3), the model's, turned over if the match is mirrored
    triangles: int  #: how many of these have three places on the data
    folded: int  #: of those, how many lie there with the wrong side up

    def frame(self, share: float) -> np.ndarray:
        """The vertices (n, 3) at a share of the way, 0 the start and 1 the end; they go straight."""
        return (1 - share) * self.start + share * self.end

    def write(self, path: str | os.PathLike[str], colours: Any = None) -> None:
        """Writes a .glb with a morph target and an animation of four seconds, there and back.

        `colours`: of the vertices, (n, 3), 0 to 255. Throws ValueError for others, OSError if the file cannot be written.
        """
        if self.start.shape != self.end.shape:
            raise ValueError(f"the start has the shape {self.start.shape} and the end {self.end.shape}, but they must have one")
        rows = np.empty((0, 3)) if colours is None else np.asarray(colours)
        if rows.shape not in ((0, 3), self.start.shape) or (rows.size and not 0 <= rows.min() <= rows.max() <= 255):
            raise ValueError(f"the colours must be {self.start.shape}, from 0 to 255, but have the shape {rows.shape}")
        if Path(path).suffix.lower() != ".glb":
            raise ValueError(f"a morph is written as .glb, not as '{path}'")
        _core.write_morph(Path(path), self.start, self.end, self.faces, rows.astype(np.uint8).tolist())

    def __repr__(self) -> str:
        return f"<homolog.Morph: {len(self.start)} vertices, {self.folded} of {self.triangles} triangles folded over>"

    def _repr_html_(self) -> str:
        way = mean_of(np.linalg.norm(self.end - self.start, axis=1), slice(None))
        counts = map(str, (len(self.start), len(self.faces), self.triangles, self.folded))
        return html_table(["vertices", "faces", "triangles", "folded", "mean way"], [[*counts, way]])


def dense_of(fields: dict[str, Any], model: Shape, data: Shape) -> tuple[Dense, Morph]:
    """From what _core returns."""
    there, back = (DenseMap(**fields[name]) for name in ("data_from_model", "model_from_data"))
    return Dense(there, back, model, data), Morph(**fields["morph"])
