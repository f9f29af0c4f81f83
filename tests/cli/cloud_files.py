# SPDX-License-Identifier: MIT
# A small point cloud with normals in every format that is read, made in code.
import math
import struct

import bear


def points():
    """Points of an ellipsoid and its normals there, as (x, y, z, nx, ny, nz)."""
    ball, _ = bear.octahedron_ball((0, 0, 0), 1, 3)  # 258 points; of less than a hundred no surface is made
    normals = [(x / 4, y, z) for x, y, z in ball]
    return [(4 * x, y, z, *(c / math.hypot(*n) for c in n)) for (x, y, z), n in zip(ball, normals)]


def xyz():
    return "".join("%r %r %r %r %r %r\n" % x for x in points()).encode()


def ply(form):
    names = [f"property double {name}" for name in ("x", "y", "z")] + [f"property float {name}" for name in ("nx", "ny", "nz")]
    header = "\n".join(["ply", f"format {form} 1.0", f"element vertex {len(points())}", *names, "end_header\n"]).encode()
    return header + (xyz() if form == "ascii" else b"".join(struct.pack("<3d3f", *x) for x in points()))
