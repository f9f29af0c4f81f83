# SPDX-License-Identifier: MIT
# One small closed solid, a ball with an ear, in every mesh format that the program reads, and clouds and label volumes. Standard library only.
import base64
import gzip
import io
import json
import struct
import zipfile

import bear
import cloud_files
import fbx_files
import volume_files
import vtk_files


def solid():
    """Vertices and triangles."""
    vertices, faces = [], []
    for centre, radius in (((0, 0, 0), 1), ((1, 0.75, 0.25), 0.5)):
        more, corners = bear.octahedron_ball(centre, radius, 1)
        faces += [tuple(len(vertices) + i for i in face) for face in corners]
        vertices += more
    return vertices, faces


def lines(*some):
    return ("\n".join(some) + "\n").encode()


def coff(v, f):
    rows = bear.off(v, f).encode().split(b"\n")
    return b"C" + b"\n".join(row + b" 1 0 0 1" * (2 <= i < 2 + len(v)) for i, row in enumerate(rows))


def obj(v, f):
    return lines("mtllib none.mtl", "o solid", *("v %r %r %r" % x for x in v), "usemtl red", *("f %d %d %d" % (a + 1, b + 1, c + 1) for a, b, c in f))


def stl_text(v, f):
    facets = []
    for face in f:
        facets += ["facet normal 0 0 0", "outer loop", *("vertex %r %r %r" % v[i] for i in face), "endloop", "endfacet"]
    return lines("solid it", *facets, "endsolid it")


def stl_binary(v, f):
    return bytes(80) + struct.pack("<I", len(f)) + b"".join(struct.pack("<12fH", 0, 0, 0, *(c for i in face for c in v[i]), 0) for face in f)


def ply(v, f, form):
    header = lines("ply", f"format {form} 1.0", f"element vertex {len(v)}", "property double x", "property double y", "property float z",
                   f"element face {len(f)}", "property list uchar int vertex_indices", "end_header")  # fmt: skip
    if form == "ascii":
        return header + lines(*("%r %r %r" % x for x in v), *("3 %d %d %d" % t for t in f))
    order = "<" if "little" in form else ">"
    return header + b"".join(struct.pack(order + "ddf", *x) for x in v) + b"".join(struct.pack(order + "B3i", 3, *t) for t in f)


def gltf_parts(v, f):
    """The JSON and the buffer of a glTF scene with one moved node."""
    positions = b"".join(struct.pack("<3f", *x) for x in v)
    corners = b"".join(struct.pack("<3H", *t) for t in f)
    low, high = [min(x[a] for x in v) for a in range(3)], [max(x[a] for x in v) for a in range(3)]
    scene = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": [1, 2, 3]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(v), "type": "VEC3", "min": low, "max": high},
            {"bufferView": 1, "componentType": 5123, "count": 3 * len(f), "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": len(positions)},
            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(corners)},
        ],
        "buffers": [{"byteLength": len(positions) + len(corners)}],
    }
    return scene, positions + corners


def gltf(v, f, uri=None):
    """With its buffer inside, or in the file `uri`."""
    scene, data = gltf_parts(v, f)
    scene["buffers"][0]["uri"] = uri or "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps(scene).encode()


def glb(v, f):
    return glb_of(*gltf_parts(v, f))


def glb_of(scene, data):
    text = json.dumps(scene).encode()
    chunks = b""
    for kind, body, fill in ((b"JSON", text, b" "), (b"BIN\0", data, b"\0")):
        body += fill * (-len(body) % 4)
        chunks += struct.pack("<I", len(body)) + kind + body
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def rigged_glb(v, f, neck, animated=True):
    """With joints at the origin and at y = neck, a shape key that lifts what is above by up to .5, and perhaps an animation of nothing."""
    scene, data = gltf_parts(v, f)

    def table(rows, form, **more):
        nonlocal data
        data += bytes(-len(data) % 4)
        body = b"".join(struct.pack("<" + form, *row) for row in rows)
        scene["bufferViews"].append({"buffer": 0, "byteOffset": len(data), "byteLength": len(body)})
        data += body
        kind = {"4B": (5121, "VEC4"), "4f": (5126, "VEC4"), "3f": (5126, "VEC3"), "16f": (5126, "MAT4"), "f": (5126, "SCALAR")}[form]
        scene["accessors"].append({"bufferView": len(scene["bufferViews"]) - 1, "componentType": kind[0], "type": kind[1], "count": len(rows), **more})
        return len(scene["accessors"]) - 1

    share = [min(max((x[1] - neck) / 0.6 + 0.5, 0), 1) for x in v]
    highest = max(x[1] for x in v)
    primitive = scene["meshes"][0]["primitives"][0]
    scene["accessors"][1].update(componentType=5125)
    corners = b"".join(struct.pack("<3I", *t) for t in f)
    scene["bufferViews"][1].update(byteOffset=len(data), byteLength=len(corners))
    data += corners
    primitive["attributes"]["JOINTS_0"] = table([(0, 1, 0, 0)] * len(v), "4B")
    primitive["attributes"]["WEIGHTS_0"] = table([(1 - s, s, 0, 0) for s in share], "4f")
    primitive["targets"] = [{"POSITION": table([(0, 0.5 * max(x[1] - neck, 0) / (highest - neck), 0) for x in v], "3f", min=[0, 0, 0], max=[0, 0.5, 0])}]
    scene["meshes"][0]["extras"] = {"targetNames": ["grow"]}
    identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]
    matrices = table([(*identity, 0, 0, 0, 1), (*identity, 0, -neck, 0, 1)], "16f")
    scene["nodes"] = [{"mesh": 0, "skin": 0}, {"name": "body", "children": [2]}, {"name": "head", "translation": [0, neck, 0]}]
    scene["scenes"] = [{"nodes": [0, 1]}]
    scene["skins"] = [{"joints": [1, 2], "inverseBindMatrices": matrices}]
    if animated:
        sampler = {"input": table([(0,), (1,)], "f", min=[0], max=[1]), "output": table([(0, 0, 0), (0, 1, 0)], "3f")}  # it leaps
        scene["animations"] = [{"samplers": [sampler], "channels": [{"sampler": 0, "target": {"node": 1, "path": "translation"}}]}]
    scene["buffers"][0]["byteLength"] = len(data)
    return glb_of(scene, data)


def read_glb(content):
    """The JSON, and a function from the number of an accessor to its rows."""
    size = struct.unpack_from("<I", content, 12)[0]
    scene = json.loads(content[20 : 20 + size])

    def table(number):
        accessor = scene["accessors"][number]
        form = "<" + {"VEC3": 3, "VEC4": 4, "MAT4": 16}[accessor["type"]] * {5126: "f", 5123: "H"}[accessor["componentType"]]
        start = 28 + size + scene["bufferViews"][accessor["bufferView"]]["byteOffset"]
        return [struct.unpack_from(form, content, start + i * struct.calcsize(form)) for i in range(accessor["count"])]

    return scene, table


def zipped(files):
    """A zip archive with the same bytes every time."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(zipfile.ZipInfo(name), text, zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def model_of_3mf(v, f):
    return (
        '<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources>'
        '<object id="1" type="model"><mesh><vertices>'
        + "".join('<vertex x="%r" y="%r" z="%r"/>' % x for x in v)
        + "</vertices><triangles>"
        + "".join('<triangle v1="%d" v2="%d" v3="%d"/>' % t for t in f)
        + '</triangles></mesh></object></resources><build><item objectid="1"/></build></model>'
    )


def threemf(model, more=None):
    relations = (
        '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship '
        'Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>'
    )
    types = (
        '<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="model" '
        'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>'
    )
    return zipped({"[Content_Types].xml": types, "_rels/.rels": relations, "3D/3dmodel.model": model, **(more or {})})


def parts_beside_3mf(v, f):
    """As slicers write it: the mesh stands in another part of the archive, beside an object that is not printed."""
    production = 'xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" requiredextensions="p"'
    mesh, far = model_of_3mf(v, f), '<vertex x="9" y="9" z="9"/>'
    core = 'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"'
    root = (
        f'<?xml version="1.0"?><model unit="millimeter" {core} {production}><resources><object id="2" type="model"><components>'
        '<component p:path="/3D/Objects/a_1.model" objectid="1" transform="1 0 0 0 1 0 0 0 1 1 2 3"/></components></object>'
        f'<object id="3" type="other"><mesh><vertices>{3 * far}</vertices><triangles><triangle v1="0" v2="1" v3="2"/>'
        '</triangles></mesh></object></resources><build><item objectid="2" transform="1 0 0 0 1 0 0 0 1 -1 -2 -3"/><item objectid="3"/></build></model>'
    )
    return threemf(root, {"3D/Objects/a_1.model": mesh[: mesh.index("<build>")] + "<build/></model>"})


def quantised_glb(v, f):
    """KHR_mesh_quantization: positions are whole numbers of 16 bits, the node scales them back."""
    scene, data = gltf_parts(v, f)
    low, step = [min(x[a] for x in v) for a in range(3)], max(max(x[a] for x in v) - min(x[a] for x in v) for a in range(3)) / 65535
    positions = b"".join(struct.pack("<4H", *(round((x[a] - low[a]) / step) for a in range(3)), 0) for x in v)
    corners = data[12 * len(v) :]
    scene["accessors"][0].update(componentType=5123)
    del scene["accessors"][0]["min"], scene["accessors"][0]["max"]
    scene["bufferViews"] = [{"buffer": 0, "byteOffset": 0, "byteLength": len(positions), "byteStride": 8},
                            {"buffer": 0, "byteOffset": len(positions), "byteLength": len(corners)}]  # fmt: skip
    scene["buffers"][0]["byteLength"] = len(positions) + len(corners)
    scene["nodes"] = [{"mesh": 0, "scale": [step] * 3, "translation": low}]
    scene.update(extensionsUsed=["KHR_mesh_quantization"], extensionsRequired=["KHR_mesh_quantization"])
    return glb_of(scene, positions + corners)


def ac3d(v, f):
    surfaces = []
    for face in f:
        surfaces += ["SURF 0x20", "mat 0", "refs 3", *(f"{i} 0 0" for i in face)]
    return lines("AC3Db", 'MATERIAL "red" rgb 1 0 0 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 10 trans 0', "OBJECT world", "kids 1",
                 "OBJECT poly", 'name "solid"', f"numvert {len(v)}", *("%r %r %r" % x for x in v), f"numsurf {len(f)}", *surfaces, "kids 0")  # fmt: skip


def collada(v, f):
    numbers, corners = " ".join(repr(c) for x in v for c in x), " ".join(str(i) for t in f for i in t)
    return (
        '<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis>'
        '</asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="%d">%s</float_array><technique_common>'
        '<accessor source="#a" count="%d" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>'
        '</accessor></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="%d">'
        '<input semantic="VERTEX" source="#v" offset="0"/><p>%s</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>'
        '<visual_scene id="s"><node id="n"><translate>1 2 3</translate><instance_geometry url="#g"/></node></visual_scene>'
        '</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>'
        % (3 * len(v), numbers, len(v), len(f), corners)
    ).encode()


def all_files():
    """Contents by file name; some names stand for another way to write the same format."""
    v, f = solid()
    return {
        "solid.off": bear.off(v, f).encode(),
        "coloured.off": coff(v, f),
        "solid.obj": obj(v, f),
        "text.stl": stl_text(v, f),
        "binary.stl": stl_binary(v, f),
        "text.ply": ply(v, f, "ascii"),
        "little.ply": ply(v, f, "binary_little_endian"),
        "big.ply": ply(v, f, "binary_big_endian"),
        "solid.gltf": gltf(v, f),
        "solid.glb": glb(v, f),
        "quantised.glb": quantised_glb(v, f),
        "rigged.glb": rigged_glb(v, f, neck=0.9),
        "solid.3mf": threemf(model_of_3mf(v, f)),
        "parts.3mf": parts_beside_3mf(v, f),
        "text.vtk": vtk_files.vtk(v, f, False),
        "binary.vtk": vtk_files.vtk(v, f, True),
        "text.vtp": vtk_files.vtp(v, f, "ascii"),
        "base64.vtp": vtk_files.vtp(v, f, "binary"),
        "compressed.vtp": vtk_files.vtp(v, f, "appended"),
        "grid.vtu": vtk_files.vtu(v, f),
        "solid.ac": ac3d(v, f),
        "solid.dae": collada(v, f),
        "text.fbx": fbx_files.fbx_text(v, f),
        "binary.fbx": fbx_files.fbx_binary(v, f),
        "solid.3ds": fbx_files.threeds(v, f),
        "cloud.xyz": cloud_files.xyz(),
        "cloud.ply": cloud_files.ply("ascii"),
        "binary_cloud.ply": cloud_files.ply("binary_little_endian"),
        "labels.nii": volume_files.nifti(),
        "labels2.nii": volume_files.nifti2(),
        "packed.nii.gz": gzip.compress(volume_files.nifti(), mtime=0),
        "labels.nrrd": volume_files.nrrd("raw"),
        "packed.nrrd": volume_files.nrrd("gzip"),
        "beside.nhdr": volume_files.nrrd_header(),
        "beside.mhd": volume_files.metaimage_header(),
        "labels.mha": volume_files.metaimage(False),
        "packed.mha": volume_files.metaimage(True),
    }
