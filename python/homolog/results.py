# SPDX-License-Identifier: MIT
"""What calls return: plain numpy arrays with names, in the coordinates and units of the shapes. All of it pickles."""
from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from homolog import _core
from homolog.dense import Dense, Morph, dense_of
from homolog.landmarks import Carried, Landmarks
from homolog.tables import html_table, mean_of

if TYPE_CHECKING:
    from homolog.shapes import Shape


def _places(points: Any) -> np.ndarray:
    places = np.asarray(points.position if isinstance(points, Landmarks) else points, np.float64)
    if places.ndim not in (1, 2) or places.shape[-1] != 3:
        raise ValueError(f"the points have the shape {places.shape}, but must have (n, 3) or (3,)")
    return places


_UNKNOWN = {"there": False, "coverage": 0.0}  #: of points that are missing already
_HEADS = ["rank", "pairs", "confidence", "handedness", "scale", "bending", "chamfer", "of model", "of data"]


@dataclass(frozen=True, eq=False, repr=False)
class Points:
    """The n salient points of a shape, largest radius first."""

    position: np.ndarray  #: (n, 3)
    radius: np.ndarray  #: (n,), of the ball that would answer at this scale
    direction: np.ndarray  #: (n, 3), unit length; NaN where a point has none
    response: np.ndarray  #: (n,), share of a ball's: ball 1, cylinder .79, plate .52

    def __len__(self) -> int:
        return len(self.position)

    def __repr__(self) -> str:
        return f"<homolog.Points: {len(self)} salient points>"

    def _repr_html_(self) -> str:
        means = [mean_of(self.radius, slice(None)), mean_of(self.response, slice(None))]
        return html_table(["salient points", "mean radius", "mean response"], [[str(len(self)), *means]])


@dataclass(frozen=True, eq=False, repr=False)
class ThinPlateSpline:
    """f(x) = affine [x; 1] + sum_k weights_k phi(|x - centres_k|), with phi(r) = r or r^3; called on points it maps them."""

    kernel: str  #: "r" or "r3"
    centres: np.ndarray  #: (k, 3)
    weights: np.ndarray  #: (k, 3)
    affine: np.ndarray  #: (3, 4)

    def __call__(self, points: Any) -> np.ndarray:
        """Maps points (n, 3), or one (3,), to as many. Throws ValueError for another shape."""
        places = _places(points)
        mapped = _core.warp(self.kernel, self.centres, self.weights, self.affine, np.atleast_2d(places))
        return mapped.reshape(places.shape)

    def __repr__(self) -> str:
        return f"<homolog.ThinPlateSpline: {len(self.centres)} centres>"


@dataclass(frozen=True, eq=False, repr=False)
class Match:
    """One place where the model, or a part of it, occurs in the data: k pairs of points and the map between the shapes."""

    pairs: np.ndarray  #: (k, 2), numbers of the paired points in Family.model and Family.data, or in Family.followed beyond those
    pair_confidence: np.ndarray  #: (k,), 0 to 1
    model_points: np.ndarray  #: (k, 3)
    data_points: np.ndarray  #: (k, 3), in the order of model_points
    data_from_model: ThinPlateSpline  #: maps places of the model to the data
    similarity: np.ndarray  #: (4, 4), the similarity nearest to that map, from model to data, too
    scale: float  #: of that similarity
    handedness: str  #: "proper", "mirrored" or "ambiguous"
    confidence: float  #: that the match is right, 0 to 1
    bending: float  #: of the spline through the pairs, without unit
    chamfer: float  #: mean distance of the mapped covered part to the data, in data diagonals
    model_coverage: float  #: share of the model's surface that the match explains, 0 to 1
    data_coverage: float  #: the same of the data's
    model_part: np.ndarray  #: one for each vertex of the model, how surely it lies in the part that the match covers, 0 to 1
    data_part: np.ndarray  #: the same of the data's
    _map: _core.MatchMap

    def carry_to_data(self, points: Any) -> Carried:
        """Carries points of the model, (n, 3), (3,) or Landmarks, to the data by `data_from_model`. NaN, missing, stays so."""
        return self._carry(points, True)

    def carry_to_model(self, points: Any) -> Carried:
        """Carries points of the data to the model by the inverse of `data_from_model`, so that they come back to where they were."""
        return self._carry(points, False)

    def _carry(self, points: Any, to_data: bool) -> Carried:
        places = _places(points)
        rows = np.atleast_2d(places)
        known = np.isfinite(rows).all(axis=1)
        carried = {}
        for name, field in self._map.carry(rows[known], to_data).items():
            whole = np.full((len(rows), *field.shape[1:]), _UNKNOWN.get(name, np.nan), field.dtype)
            whole[known] = field
            carried[name] = whole.reshape(places.shape[:-1] + field.shape[1:])
        return Carried(**carried)

    def _row(self) -> list[str]:
        numbers = [f"{self.scale:.4g}", f"{self.bending:.4f}", f"{self.chamfer:.4f}"]
        shares = [f"{self.model_coverage:.0%}", f"{self.data_coverage:.0%}"]
        return [str(len(self.pairs)), f"{self.confidence:.2f}", self.handedness, *numbers, *shares]

    def __repr__(self) -> str:
        return f"<homolog.Match: {', '.join(f'{h} {v}' for h, v in zip(_HEADS[1:], self._row()))}>"

    def _repr_html_(self) -> str:
        return html_table(_HEADS[1:], [self._row()])


@dataclass(frozen=True, eq=False, repr=False)
class Symmetry:
    """How a match lays a shape onto itself: by the reflection in a plane, or by the similarity that moves a part to where it is repeated."""

    normal: np.ndarray | None  #: (3,), unit length, of the mirror plane normal . x = offset; None of a repeated part
    offset: float | None  #: of that plane, in the unit of the shape
    matrix: np.ndarray  #: (4, 4), the reflection or the similarity
    error: float  #: how exact: root of the mean square distance from the surface at which the part lies then, in diagonals
    sentence: str  #: the same in words

    def __repr__(self) -> str:
        return f"<homolog.Symmetry: {self.sentence}>"



@dataclass(frozen=True, eq=False, repr=False)
class Family(Sequence[Match]):
    """All matches, best first; false when nothing was found, and `counts` tells at which stage the last candidate died."""

    matches: tuple[Match, ...]
    counts: dict[str, int]  #: how many candidates each stage let through, in order
    model: Shape
    data: Shape
    followed: Points  #: places in the data to which matches follow a point of the model; their numbers go on those of data.points
    doubt: str  #: a sentence when no match is likely to be right, else empty
    _found: _core.Found
    symmetries: tuple[Symmetry, ...] = ()  #: of homolog.symmetry: what each match says, in their order; empty of homolog.match

    def __len__(self) -> int:
        return len(self.matches)

    @overload
    def __getitem__(self, rank: int) -> Match: ...
    @overload
    def __getitem__(self, rank: slice) -> tuple[Match, ...]: ...
    def __getitem__(self, rank: int | slice) -> Match | tuple[Match, ...]:
        try:
            return self.matches[rank]
        except IndexError:
            has = f"has {len(self)}, and the best one is 0" if self.matches else "is empty, for nothing was found"
            raise IndexError(f"there is no match {rank}: the family {has}") from None

    def dense(self, rank: int = 0) -> Dense:
        """For every vertex of either mesh its place on the other one, by a match; what is there can be carried over."""
        return self._laid(rank)[0]

    def morph(self, rank: int = 0) -> Morph:
        """The model turning into the data, by a match."""
        return self._laid(rank)[1]

    def transfer(
        self,
        source: Any,
        out: Any,
        rank: int = 0,
        *,
        onto: Any = None,
        to_model: bool = False,
        labels: Sequence[str] = (),
        fill: bool = False,
    ) -> int:
        """What is painted on a copy of the model, carried to the data and written as a file; returns how many vertices have it.

        `source` and `out` are .ply (colours, values, labels, UVs with their pictures), .obj (UVs, materials, pictures), .glb or .gltf (all
        of these, skins, shape keys, animations). `onto`: the mesh that receives it, in the data's coordinates, in any form that `describe` takes; else the data. `to_model`:
        from a copy of the data to the model. `labels`: fields that hold labels although their type is not whole. `fill`: leave no holes,
        what has no place gets what is nearest to where the match lays it. What `out` cannot hold is told by a UserWarning. Throws OSError
        for files that cannot be read or written, for an `out` that would replace what was read, and for a `source` or `onto` that lies elsewhere than the shape that was matched.
        """
        from homolog.shapes import surface_of

        receiver = self.model if to_model else self.data
        if onto is None:
            receiver.require_mesh()
        vertices, faces = (receiver.vertices, receiver.faces) if onto is None else surface_of(onto)[:2]
        giver = self.data if to_model else self.model
        read = [Path(os.fsdecode(onto))] if isinstance(onto, (str, bytes, os.PathLike)) else []
        onto_name = str(read[0]) if read else "onto" if onto is not None else receiver.name or "the receiver"
        names = [giver.name or "the giver", receiver.name or "the receiver", onto_name]
        placed, losses = self[rank]._map.transfer(Path(source), Path(out), vertices, faces, not to_model, list(labels), fill, names, read)
        for loss in losses:
            warnings.warn(loss, UserWarning, stacklevel=2)
        return int(placed)

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Writes the folder that `homolog match --out` or `homolog symmetry --out` writes, report.html too; homolog.load reads it again.

        Throws OSError if it cannot be written, and leaves it as it was then.
        """
        if len(self.matches) != self._found.matches:
            raise ValueError("the matches of this family were changed; save the family that was found")
        parts = [(match._map, match.model_part, match.data_part) for match in self.matches]
        if any(np.isnan(weights).any() for part in parts for weights in part[1:]):
            raise ValueError("the covered parts are not known, for no parts.json lay beside the match.json; match the shapes again")
        _core.save(self._found, Path(folder), *self._meshes(), parts)

    def _meshes(self) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        self.model.require_mesh()
        self.data.require_mesh()
        return self.model.vertices, self.model.faces, self.data.vertices, self.data.faces

    def _laid(self, rank: int) -> tuple[Dense, Morph]:
        return dense_of(self[rank]._map.dense(*self._meshes()), self.model, self.data)

    def plot(self, rank: int = 0, **keywords: Any) -> Any:
        """Draws a match with PyVista (`pip install homolog[viz]`): both meshes, the covered parts in colour, the pairs with their numbers.

        The keywords go to `pyvista.Plotter.show`; homolog.viz.plotter gives the plotter itself.
        """
        from homolog.viz import plotter

        return plotter(self, rank).show(**keywords)

    def _rows(self) -> list[list[str]]:
        return [[str(rank), *match._row()] for rank, match in enumerate(self.matches, 1)]

    def __repr__(self) -> str:
        rows = [_HEADS, *self._rows()]
        widths = [max(map(len, column)) for column in zip(*rows)]
        table = "\n".join("  ".join(cell.rjust(width) for cell, width in zip(row, widths)) for row in rows)
        said = "".join(f"\n{rank:4}  {symmetry.sentence}" for rank, symmetry in enumerate(self.symmetries, 1))
        doubt = f"\n{self.doubt}" if self.doubt else ""
        return table + doubt + said if self.matches else f"nothing found; {self._counted()}"

    def _counted(self) -> str:
        return ", ".join(f"{stage} {count}" for stage, count in self.counts.items())

    def _repr_html_(self) -> str:
        if not self.matches:
            return f"<p>{self!r}</p>"
        said = "".join(f"<li>{symmetry.sentence}</li>" for symmetry in self.symmetries)
        table = html_table(_HEADS, self._rows())
        doubt = f"<p>{self.doubt}</p>" if self.doubt else ""
        return table + doubt + (f"<ol>{said}</ol>" if said else "")


def family_of(fields: tuple[tuple[Any, ...], list[dict[str, Any]] | None, _core.Found], model: Shape, data: Shape) -> Family:
    """From what _core returns."""
    (matches, counts, followed, doubt), symmetries, found = fields
    made = (Match(**{**match, "data_from_model": ThinPlateSpline(**match["data_from_model"])}) for match in matches)
    told = tuple(Symmetry(**symmetry) for symmetry in symmetries or ())
    return Family(tuple(made), counts, model, data, Points(**followed), doubt, found, told)
