# SPDX-License-Identifier: MIT
# Files as strangers have them: of one bear in the habits of many programs, and of what is no shape. Of each either the points of the plain
# bear must come, or one sentence that holds the words given here. Standard library only.
#   python3 tests/cli/odd_files.py build/release/cli/homolog      runs all and prints what was answered
import gzip
import json
import math
import os
import struct
import subprocess
import sys
import tempfile

import bear
import fbx_files
import mesh_files
import vtk_files

POINTS = None  # instead of words: the points of the plain bear
OPEN = object()  # the same, and a warning that it is open


def plain():
    v, f = [], []
    for centre, radius in bear.bear_balls((1.9, 0.9, 0.4)):
        more, faces = bear.octahedron_ball(centre, radius, 3)
        f += [tuple(len(v) + i for i in face) for face in faces]
        v += more
    return v, f


def text_of(rows):
    return ("\n".join(rows) + "\n").encode()


def obj(v, f, corner="%d"):
    return text_of(["v %r %r %r" % x for x in v] + ["f " + " ".join(corner % (i + 1) for i in t) for t in f])


def objs(v, f):
    yield "negative.obj", text_of(["v %r %r %r" % x for x in v] + ["f %d %d %d" % tuple(i - len(v) for i in t) for t in f]), POINTS
    yield "colours, normals.obj", text_of(["v %r %r %r .5 .5 .5" % x for x in v] + ["vn 0 0 1"] + ["f %d//1 %d//1 %d//1" % tuple(i + 1 for i in t) for t in f]), POINTS  # fmt: skip
    yield "windows.obj", obj(v, f).replace(b"\n", b"\r\n"), POINTS
    yield "old mac.obj", obj(v, f).replace(b"\n", b"\r"), "old Macs"
    yield "mark.obj", b"\xef\xbb\xbf" + obj(v, f), POINTS
    yield "mark.off", b"\xef\xbb\xbf" + bear.off(v, f).encode(), POINTS
    yield "mark.stl", b"\xef\xbb\xbf" + mesh_files.stl_text(v, f), POINTS
    yield "utf16.obj", obj(v, f).decode().encode("utf-16"), "UTF-16"
    yield "comma.obj", obj(v, f).replace(b".", b","), "decimal point"
    yield "lines.obj", b"v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\n", "no triangles"
    yield "blank.obj", b"\n \n\n", "no triangles"
    yield "twice.obj", obj(v, f) * 2, POINTS
    yield "nan.obj", obj(v, f) + b"v nan nan nan\n", "'nan' is not a finite number"


def names(v, f):
    yield "off inside.obj", bear.off(v, f).encode(), POINTS
    yield "obj inside.stl", obj(v, f), POINTS
    yield "obj inside.txt", obj(v, f), POINTS
    yield "stl inside.obj", mesh_files.stl_binary(v, f), POINTS
    yield "stl text inside.ply", mesh_files.stl_text(v, f), POINTS
    yield "ply inside.stl", mesh_files.ply(v, f, "binary_little_endian"), POINTS
    yield "no ending", bear.off(v, f).encode(), POINTS
    scene, data = mesh_files.gltf_parts(v, f)
    yield "glb inside.obj", mesh_files.glb_of({**scene, "nodes": [{"mesh": 0}]}, data), POINTS
    yield "fbx inside.obj", fbx_files.fbx_binary(v, f), POINTS
    yield "collada inside.xml", mesh_files.collada(v, f).replace(b"1 2 3</tr", b"0 0 0</tr"), POINTS
    yield "3mf inside.zip", mesh_files.threemf(mesh_files.model_of_3mf(v, f)), POINTS
    yield "ac3d inside.stl", mesh_files.ac3d(v, f), POINTS
    yield "mesh.obj.gz", gzip.compress(obj(v, f), mtime=0), "unpack it first"
    yield "mesh.zip", mesh_files.zipped({"mesh.obj": obj(v, f)}), "unpack it first"


def stls(v, f):
    binary, text = mesh_files.stl_binary(v, f), mesh_files.stl_text(v, f)
    yield "solid but binary.stl", b"solid of a CAD program".ljust(80) + binary[80:], POINTS
    yield "nonsense header.stl", bytes((37 * i + 11) % 256 for i in range(80)) + binary[80:], POINTS
    yield "seven bytes more.stl", binary + bytes(7), POINTS
    yield "capitals.stl", text.upper(), POINTS
    yield "blank lines first.stl", b"\n  " + text, POINTS
    yield "without solid.stl", text.split(b"\n", 1)[1], "begins with 'solid'"
    yield "without end.stl", text.replace(b"endsolid it\n", b""), "endsolid"
    yield "no triangles.stl", bytes(84), "no triangles"


def plys(v, f):
    head = "ply\nformat ascii 1.0\ncomment by hand\n"
    vertex = f"element vertex {len(v)}\nproperty float x\nproperty float y\nproperty float z\n"
    face = f"element face {len(f)}\nproperty list int uint vertex_index\n"
    points, corners = text_of(["%r %r %r" % x for x in v]), text_of(["3 %d %d %d" % t for t in f])
    yield "big.ply", mesh_files.ply(v, f, "binary_big_endian"), POINTS
    yield "more elements.ply", (head + vertex + face + "element edge 1\nproperty int vertex1\nend_header\n").encode() + points + corners + b"0\n", POINTS  # fmt: skip
    yield "faces first.ply", (head + face + vertex + "end_header\n").encode() + corners + points, "vertices first"
    yield "strips.ply", (head + vertex + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n").encode() + points + b"3 0 1 2\n", "strips"  # fmt: skip
    yield "points alone.ply", (head + vertex + "end_header\n").encode() + points, "estimate normals"


def clouds(v, f):
    del f
    balls = bear.bear_balls((1.9, 0.9, 0.4))
    rows = []
    for centre, radius in balls:
        for n in bear.octahedron_ball((0, 0, 0), 1, 4)[0]:
            x = tuple(c + radius * k for c, k in zip(centre, n))
            if all(math.dist(x, c) >= r - 1e-9 for c, r in balls):
                rows.append((*x, *n))
    yield "cloud.xyz", text_of(["%r %r %r %r %r %r" % x for x in rows]), POINTS
    yield "cloud with nan.xyz", text_of([("%r %r %r nan nan nan" % x[:3]) if i % 10 == 0 else "%r %r %r %r %r %r" % x for i, x in enumerate(rows)]), POINTS  # fmt: skip
    yield "cloud inward.xyz", text_of(["%r %r %r %r %r %r" % (x[:3] + tuple(-c for c in x[3:])) for x in rows]), POINTS
    yield "cloud comma.xyz", text_of(["%r, %r, %r, %r, %r, %r" % x for x in rows]), "blanks between numbers"
    yield "cloud colours.xyz", text_of(["%r %r %r 200 100 7" % x for x in v]), "a colour, perhaps"
    yield "cloud points.xyz", text_of(["%r %r %r" % x for x in v]), "estimate normals"


def gltfs(v, f):
    def with_(**changes):
        scene, data = mesh_files.gltf_parts(v, f)
        scene["nodes"] = [{"mesh": 0}]
        scene.update(changes)
        return mesh_files.glb_of(scene, data)

    yield "plain.glb", with_(), POINTS
    yield "mirrored twice.glb", with_(nodes=[{"scale": [-1, 1, 1], "children": [1]}, {"mesh": 0, "scale": [-1, 1, 1]}]), POINTS
    for name in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing"):
        yield f"{name}.glb", with_(extensionsUsed=[name], extensionsRequired=[name]), name
    yield "quantised.glb", mesh_files.quantised_glb(v, f), POINTS
    yield "version 1.gltf", json.dumps({"asset": {"version": "1.0"}}).encode(), "not glTF 2.0"
    yield "buffer missing.gltf", mesh_files.gltf(v, f, "missing.bin"), "missing.bin"
    yield "no mesh.gltf", json.dumps({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{}]}).encode(), "no triangles"


def vtks(v, f):
    yield "text.vtk", vtk_files.vtk(v, f, False), POINTS
    yield "binary.vtk", vtk_files.vtk(v, f, True), POINTS
    yield "lines.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n0 0 0 1 1 1\nLINES 1 3\n2 0 1\n", "no triangles"
    tetrahedron = b"0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
    yield "solid cells.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n" + tetrahedron, "extract their surface"
    yield "text.vtp", vtk_files.vtp(v, f, "ascii"), POINTS
    yield "base64.vtp", vtk_files.vtp(v, f, "binary"), POINTS
    yield "compressed.vtp", vtk_files.vtp(v, f, "appended"), POINTS
    yield "lz4.vtp", vtk_files.vtp(v, f, "appended").replace(b"vtkZLib", b"vtkLZ4"), "save it with zlib"


def others(v, f):
    yield "moved.3mf", mesh_files.threemf(mesh_files.model_of_3mf([(x - 5, y, z) for x, y, z in v], f).replace('objectid="1"/', 'objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/').replace("millimeter", "inch")), POINTS  # fmt: skip
    yield "parts beside.3mf", mesh_files.parts_beside_3mf(v, f), POINTS
    yield "plain.ac", mesh_files.ac3d(v, f), POINTS
    yield "text.fbx", fbx_files.fbx_text(v, f), POINTS
    yield "binary.fbx", fbx_files.fbx_binary(v, f), POINTS
    yield "z up.dae", mesh_files.collada(v, f).replace(b"Y_UP", b"Z_UP").replace(b"1 2 3</tr", b"0 0 0</tr"), POINTS


def geometry(v, f):
    def off(vertices, faces):
        return bear.off(vertices, faces).encode()

    yield "half flipped.off", off(v, [t if i % 2 else t[::-1] for i, t in enumerate(f)]), POINTS
    yield "inside out.off", off(v, [t[::-1] for t in f]), POINTS
    yield "every face twice.off", off(v, f + [t[::-1] for t in f]), POINTS
    yield "unused vertices.off", off([*v, (1e9, 1e9, 1e9)], f), POINTS
    yield "degenerate faces.off", off(v, [*f, (0, 0, 1), (2, 2, 2), (0, 1, 0)]), POINTS
    yield "a hole.off", off(v, f[1:]), OPEN
    yield "a fin.off", off([*v, tuple(1.05 * c for c in v[0])], [*f, (f[0][0], f[0][1], len(v))]), OPEN
    inner = [tuple(0.2 * c for c in x) for x in v]
    yield "a shell within.off", off(v + inner, f + [tuple(len(v) + i for i in t) for t in f]), POINTS
    yield "soup.off", off([v[i] for t in f for i in t], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(f))]), POINTS
    grid = [(i, j, 0) for i in range(9) for j in range(9)]
    corners = [(9 * i + j, 9 * i + j + 1, 9 * i + j + 10, 9 * i + j + 9) for i in range(8) for j in range(8)]
    yield "plane.off", off(grid, [t for a, b, c, d in corners for t in ((a, b, c), (a, c, d))]), "--thicken"
    yield "one triangle.off", off([(0, 0, 0), (1, 0, 0), (0, 1, 1)], [(0, 1, 2)]), "--thicken"


def foreign(v, f):
    del v, f
    yield "page.stl", b"<!DOCTYPE html>\n<html><title>404 Not Found</title></html>\n", "a web page"
    yield "pointer.glb", b"version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n", "git lfs pull"
    yield "part.step", b"ISO-10303-21;\nHEADER;\n", "a STEP file"
    yield "part.iges", b" " * 72 + b"S      1\n" + b" " * 72 + b"G      1\n", "an IGES file"
    yield "scene.blend", b"BLENDER-v300" + bytes(99), "a Blender file"
    yield "scene.usdz", mesh_files.zipped({"a.usdc": "PXR-USDC"}), "a USD file"
    yield "slice.dcm", bytes(128) + b"DICM" + bytes(99), "a DICOM file"
    yield "image.vtk", b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n", "as polygonal data"
    yield "image.vti", b'<?xml version="1.0"?>\n<VTKFile type="ImageData">\n', "of the type ImageData"
    yield "world.wrl", b"#VRML V2.0 utf8\n", "a VRML file"
    yield "picture.stl", b"\x89PNG\r\n\x1a\n" + bytes(500), "a picture"
    yield "noise.bin", bytes((i * i * 7 + i // 3) % 251 for i in range(5000)), "is not known"


def all_files():
    """(name, content, words of the sentence, or POINTS or OPEN)"""
    v, f = plain()
    for some in (objs, names, stls, plys, clouds, gltfs, vtks, others, geometry, foreign):
        yield from some(v, f)


def answer(program, path, *more):
    """The exit code, the points as (position, radius), and the sentence without the file's name."""
    done = subprocess.run([program, "points", path, "--json", *more], capture_output=True, text=True, timeout=300, cwd=os.path.dirname(path))
    points = [(p["position"], p["radius"]) for p in json.loads(done.stdout)["shape"]["points"]] if done.returncode == 0 else []
    return done.returncode, points, done.stderr


def same(points, plain_points):
    """The share of the plain bear's points that are found again, within a quarter of their radius."""
    found = sum(any(math.dist(x, y) < r / 4 and abs(math.log(s / r)) < 0.15 for y, s in points) for x, r in plain_points)
    return found / len(plain_points)


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "plain.off")
        with open(path, "w") as file:
            file.write(bear.off(*plain()))
        expected = answer(program, path)[1]
        print("| file | code | answer |\n|---|---|---|")
        for name, content, _ in all_files():
            path = os.path.join(folder, name)
            with open(path, "wb") as file:
                file.write(content)
            code, points, said = answer(program, path)
            found = "the points of the plain bear: " + format(same(points, expected), ".0%") if code == 0 else ""
            told = said.strip().replace("homolog: ", "").replace(path + ": ", "").replace(path, name)
            print(f"| {name} | {code} | {'; '.join(filter(None, (told, found)))} |", flush=True)


if __name__ == "__main__":
    main()
