#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What large files cost: time and memory of the program, on meshes and point clouds made here. Standard library only.

usage: large_files.py PROGRAM [--millions N] [--match] [NAME ...]

The shape is a ball with seven horns; NAME is one of the files that are printed, without one all. Prints for every file its size, the
processor seconds of `homolog points FILE` (with --match: of `homolog match FILE FILE --out DIR`) and the most memory that a process of it had.
"""
import argparse
import array
import math
import os
import random
import struct
import subprocess
import sys
import tempfile

import large_scenes
from large_scenes import triples

HORNS = [((1, 0.1, 0.2), 0.9), ((-0.8, 0.5, 0.1), 0.7), ((0.1, 1, -0.3), 1.1), ((0.2, -0.9, 0.4), 0.8), ((-0.1, 0.3, 1), 0.6),
         ((0.4, -0.3, -1), 1.0), ((-0.7, -0.6, -0.4), 0.5)]  # fmt: skip
SHARPNESS = 12


def unit_horns():
    return [(tuple(c / math.hypot(*way) for c in way), height) for way, height in HORNS]


def radius_and_slope(d, horns):
    """How far the surface is in a direction, and how that changes with the direction."""
    radius, slope = 1, [0, 0, 0]
    for (x, y, z), height in horns:
        own = height * math.exp(SHARPNESS * (d[0] * x + d[1] * y + d[2] * z - 1))
        radius += own
        slope = [slope[0] + SHARPNESS * own * x, slope[1] + SHARPNESS * own * y, slope[2] + SHARPNESS * own * z]
    return radius, slope


def shape(triangles):
    """Vertices (x, y, z, x, ...) and triangles (a, b, c, a, ...) over a grid of latitudes and longitudes, outward."""
    horns = unit_horns()
    rows = round(math.sqrt(triangles / 4))
    columns = round(triangles / 2 / (rows - 1))
    turns = [(math.cos(2 * math.pi * j / columns), math.sin(2 * math.pi * j / columns)) for j in range(columns)]
    vertices, corners = array.array("f"), array.array("I")

    def add(direction):
        r, _ = radius_and_slope(direction, horns)
        vertices.extend([r * c for c in direction])

    add((0, 0, 1))
    for i in range(1, rows):
        z, wide = math.cos(math.pi * i / rows), math.sin(math.pi * i / rows)
        for c, s in turns:
            add((wide * c, wide * s, z))
    add((0, 0, -1))
    last = len(vertices) // 3 - 1
    for j in range(columns):
        corners.extend((0, 1 + j, 1 + (j + 1) % columns, last, last - 1 - j, last - 1 - (j + 1) % columns))
    for i in range(rows - 2):
        for j in range(columns):
            a, b = 1 + i * columns + j, 1 + i * columns + (j + 1) % columns
            corners.extend((a, a + columns, b, b, a + columns, b + columns))
    return vertices, corners


def ply_header(**counts):
    lines = ["ply", "format binary_little_endian 1.0", f"element vertex {counts['vertices']}"]
    lines += [f"property float {name}" for name in counts["properties"]]
    if counts["faces"]:
        lines += [f"element face {counts['faces']}", "property list uint uint vertex_indices"]
    return "\n".join([*lines, "end_header\n"]).encode()


def write_ply(file, vertices, corners):
    file.write(ply_header(vertices=len(vertices) // 3, properties="xyz", faces=len(corners) // 3))
    vertices.tofile(file)
    for a, b, c in triples(corners):
        array.array("I", (3, a, b, c)).tofile(file)


def write_stl(file, vertices, corners):
    file.write(bytes(80) + struct.pack("<I", len(corners) // 3))
    for triangle in triples(corners):
        numbers = [x for i in triangle for x in vertices[3 * i : 3 * i + 3]]
        file.write(struct.pack("<12fH", 0, 0, 0, *numbers, 0))


def write_text_stl(file, vertices, corners):
    file.write(b"solid horns\n")
    places = [b"      vertex %e %e %e\n" % v for v in triples(vertices)]
    head, tail = b"  facet normal %e %e %e\n    outer loop\n" % (0, 0, 0), b"    endloop\n  endfacet\n"
    for a, b, c in triples(corners):
        file.write(head + places[a] + places[b] + places[c] + tail)
    file.write(b"endsolid horns\n")


def write_obj(file, vertices, corners):
    file.writelines(b"v %.9g %.9g %.9g\n" % v for v in triples(vertices))
    file.writelines(b"f %d %d %d\n" % (a + 1, b + 1, c + 1) for a, b, c in triples(corners))


def write_off(file, vertices, corners):
    file.write(b"OFF\n%d %d 0\n" % (len(vertices) // 3, len(corners) // 3))
    file.writelines(b"%.9g %.9g %.9g\n" % v for v in triples(vertices))
    file.writelines(b"3 %d %d %d\n" % t for t in triples(corners))


def write_cloud(file, count):
    """Points in directions drawn evenly, with normals."""
    horns, dice = unit_horns(), random.Random(1)
    file.write(ply_header(vertices=count, properties=["x", "y", "z", "nx", "ny", "nz"], faces=0))
    for _ in range(count):
        z, angle = dice.uniform(-1, 1), dice.uniform(0, 2 * math.pi)
        wide = math.sqrt(1 - z * z)
        d = (wide * math.cos(angle), wide * math.sin(angle), z)
        r, slope = radius_and_slope(d, horns)
        along = sum(a * b for a, b in zip(slope, d))
        normal = [(r + along) * a - b for a, b in zip(d, slope)]
        length = math.hypot(*normal)
        array.array("f", [*(r * c for c in d), *(c / length for c in normal)]).tofile(file)


def cost(words):
    """Processor seconds and the most MiB of one process."""
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = process.stderr.read().decode()
    _, status, used = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(words)} ended with {os.waitstatus_to_exitcode(status)}: {message}")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def main():
    meshes = {"mesh.ply": write_ply, "mesh.stl": write_stl, "text.stl": write_text_stl, "mesh.obj": write_obj, "mesh.off": write_off,
              "mesh.glb": large_scenes.write_glb, "mesh.3mf": large_scenes.write_3mf, "mesh.vtk": large_scenes.write_vtk,
              "mesh.vtp": large_scenes.write_vtp, "mesh.dae": large_scenes.write_collada, "mesh.ac": large_scenes.write_ac3d}  # fmt: skip
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("names", nargs="*")
    parser.add_argument("--millions", type=float, default=5)
    parser.add_argument("--match", action="store_true")
    options = parser.parse_args()
    count = round(options.millions * 1e6)
    names = options.names or [*meshes, "cloud.ply"]
    vertices, corners = shape(count) if any(name != "cloud.ply" for name in names) else (None, None)
    print(f"{'file':10} {'MB':>6} {'CPU s':>6} {'MiB':>6}")
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            path = os.path.join(folder, name)
            with open(path, "wb") as file:
                if name == "cloud.ply":
                    write_cloud(file, count)
                else:
                    meshes[name](file, vertices, corners)
            words = ["match", path, path, "--out", os.path.join(folder, "out")] if options.match else ["points", path]
            seconds, mebibytes = cost([options.program, *words])
            print(f"{name:10} {os.path.getsize(path) / 1e6:6.0f} {seconds:6.1f} {mebibytes:6.0f}", flush=True)
            os.remove(path)


if __name__ == "__main__":
    main()
