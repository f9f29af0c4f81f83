# SPDX-License-Identifier: MIT
"""Shapes of the tests, made in code: the bears of the program's tests; and results as bytes."""
import dataclasses
import sys
from pathlib import Path

import homolog
import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "cli"))
import bear  # noqa: E402
import mesh_files  # noqa: E402

ROOT = Path(__file__).parents[2]
COARSE = {"resolution": 64, "sigma0": 0.8}
ROTATION, SCALE, SHIFT = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]]), 2.5, np.array([10, -3, 1])


def bear_arrays(arm=(1.2, 1.9, 0.6)):
    """Vertices (n, 3) and faces (m, 3) of a bear made of balls; left differs from right by the arm."""
    words = bear.mesh(bear.bear_balls(arm)).split()
    n, m = int(words[1]), int(words[2])
    vertices = np.array(words[4 : 4 + 3 * n], float).reshape(-1, 3)
    return vertices, np.array(words[4 + 3 * n : 4 + 3 * n + 4 * m], int).reshape(-1, 4)[:, 1:]


def program_path():
    """The program, installed with the package or built beside it; skips the test where it is neither."""
    found = [path for path in (Path(sys.executable).with_name("homolog"), ROOT / "build/release/cli/homolog") if path.exists()]
    return found[0] if found else pytest.skip("the program is not built")


def moved(vertices):
    return SCALE * vertices @ ROTATION.T + SHIFT


def bytes_of(value):
    """A result as plain values and bytes, so that == tells whether every bit is the same."""
    if isinstance(value, np.ndarray):
        return value.dtype.str, value.shape, value.tobytes()
    if isinstance(value, homolog.Shape):
        return bytes_of((value.vertices, value.faces, value.points))
    if dataclasses.is_dataclass(value):
        return {field.name: bytes_of(getattr(value, field.name)) for field in dataclasses.fields(value)}
    if isinstance(value, (tuple, list)):
        return tuple(map(bytes_of, value))
    return bytes_of(value.__getstate__()) if type(value).__name__ in ("MatchMap", "Found") else value
