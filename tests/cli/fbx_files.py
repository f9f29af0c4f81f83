# SPDX-License-Identifier: MIT
# FBX and 3DS files of a mesh. Standard library only.
import struct

HEADER_OF_3DS, BYTES_A_CHUNK = 0x4D4D, 6


def lines(*some):
    return ("\n".join(some) + "\n").encode()


def fbx_corners(f):
    """The last corner of a polygon is told by its complement."""
    return [i for a, b, c in f for i in (a, b, ~c)]


def fbx_text(v, f):
    numbers, corners = [c for x in v for c in x], fbx_corners(f)
    return lines("; FBX 7.4.0 project file", "FBXHeaderExtension:  {", "FBXVersion: 7400", "}", "Objects:  {",
                 'Geometry: 1, "Geometry::solid", "Mesh" {', f"Vertices: *{len(numbers)} {{", "a: " + ",".join(map(repr, numbers)), "}",
                 f"PolygonVertexIndex: *{len(corners)} {{", "a: " + ",".join(map(str, corners)), "}", "}",
                 'Model: 2, "Model::solid", "Mesh" {', "Version: 232", "}", "}",
                 "Connections:  {", 'C: "OO",2,0', 'C: "OO",1,2', "}")  # fmt: skip


def int32(value):
    return b"I" + struct.pack("<i", value)


def fbx_property(value):
    if isinstance(value, bytes):
        return value
    if isinstance(value, str):
        return b"S" + struct.pack("<I", len(value)) + value.encode()
    if isinstance(value, list):
        kind, code = ("d", "d") if isinstance(value[0], float) else ("i", "i")
        return kind.encode() + struct.pack("<III", len(value), 0, struct.calcsize(code) * len(value)) + struct.pack(f"<{len(value)}{code}", *value)
    return b"L" + struct.pack("<q", value)


def fbx_node(start, name, values, *children):
    """A node that begins at byte `start`; children are (name, values, *children). It tells where it ends."""
    properties = b"".join(map(fbx_property, values))
    body = b""
    head = 13 + len(name) + len(properties)
    for child in children:
        body += fbx_node(start + head + len(body), *child)
    if children:
        body += bytes(13)
    return struct.pack("<IIIB", start + head + len(body), len(values), len(properties), len(name)) + name.encode() + properties + body


def fbx_binary(v, f):
    data = b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", 7400)
    numbers = [float(c) for x in v for c in x]
    geometry = ("Geometry", [1, "solid\0\1Geometry", "Mesh"], ("Vertices", [numbers]), ("PolygonVertexIndex", [fbx_corners(f)]))
    model = ("Model", [2, "solid\0\1Model", "Mesh"], ("Version", [int32(232)]))
    for node in (
        ("FBXHeaderExtension", [], ("FBXVersion", [int32(7400)])),
        ("Objects", [], geometry, model),
        ("Connections", [], ("C", ["OO", 2, 0]), ("C", ["OO", 1, 2])),
    ):
        data += fbx_node(len(data), *node)
    return data + bytes(13) + bytes(160)


def chunk_of_3ds(kind, body):
    return struct.pack("<HI", kind, BYTES_A_CHUNK + len(body)) + body


def threeds(v, f):
    vertices = chunk_of_3ds(0x4110, struct.pack("<H", len(v)) + b"".join(struct.pack("<3f", *x) for x in v))
    faces = chunk_of_3ds(0x4120, struct.pack("<H", len(f)) + b"".join(struct.pack("<4H", *t, 7) for t in f))
    mesh = chunk_of_3ds(0x4000, b"solid\0" + chunk_of_3ds(0x4100, vertices + faces))
    return chunk_of_3ds(HEADER_OF_3DS, chunk_of_3ds(0x0002, struct.pack("<I", 3)) + chunk_of_3ds(0x3D3D, mesh))
