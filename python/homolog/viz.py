# SPDX-License-Identifier: MIT
"""Draws matches with PyVista, which `pip install homolog[viz]` brings."""
from __future__ import annotations

from typing import Any

import numpy as np

from homolog.results import Family
from homolog.shapes import Shape

try:
    import pyvista
except ImportError as error:
    raise ImportError("drawing needs PyVista; 'pip install homolog[viz]' brings it") from error


def mesh_of(shape: Shape, part: np.ndarray) -> pyvista.PolyData:
    """A shape as PyVista's mesh with the weights of a match's part, one for each vertex, as point data "part"."""
    mesh = pyvista.PolyData(shape.vertices, np.insert(shape.faces.astype(np.int64), 0, 3, axis=1).ravel())
    mesh.point_data["part"] = part
    return mesh


def plotter(family: Family, rank: int = 0, **keywords: Any) -> pyvista.Plotter:
    """Model and data of a match side by side, the covered parts in colour, points that correspond with the same number.

    The keywords go to `pyvista.Plotter`, such as off_screen=True. Throws IndexError for a family without that match.
    """
    match = family[rank]
    made = pyvista.Plotter(shape=(1, 2), **keywords)
    sides = ((family.model, match.model_part, match.model_points), (family.data, match.data_part, match.data_points))
    for column, (shape, part, points) in enumerate(sides):
        made.subplot(0, column)
        made.add_mesh(mesh_of(shape, part), scalars="part", clim=(0, 1), cmap=["lightgrey", "teal"], opacity=0.6, show_scalar_bar=False)
        if len(points):
            made.add_point_labels(points, [str(number) for number in range(len(points))], point_size=12, font_size=12, always_visible=True, shape_opacity=0.3)
        made.add_text(("model" if column == 0 else "data") + (f": {shape.name}" if shape.name else ""), font_size=10)
    return made
