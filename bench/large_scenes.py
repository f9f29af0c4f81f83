# SPDX-License-Identifier: MIT
# Writers of large_files.py for formats with headers of their own. In: a file open for bytes, vertices (x, y, z, x, ...) and triangles
# (a, b, c, a, ...). Standard library only.
import array
import json
import struct
import zipfile


def triples(numbers):
    return zip(numbers[::3], numbers[1::3], numbers[2::3])


def write_glb(file, vertices, corners):
    places, numbers = vertices.tobytes(), corners.tobytes()
    views = [{"buffer": 0, "byteOffset": 0, "byteLength": len(places)}, {"buffer": 0, "byteOffset": len(places), "byteLength": len(numbers)}]
    box = {"min": [min(vertices[k::3]) for k in range(3)], "max": [max(vertices[k::3]) for k in range(3)]}
    accessors = [{"bufferView": 0, "componentType": 5126, "count": len(vertices) // 3, "type": "VEC3", **box},
                 {"bufferView": 1, "componentType": 5125, "count": len(corners), "type": "SCALAR"}]  # fmt: skip
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(places) + len(numbers)}],
    }).encode()  # fmt: skip
    text += b" " * (-len(text) % 4)
    file.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(places) + len(numbers), len(text), 0x4E4F534A) + text)
    file.write(struct.pack("<II", len(places) + len(numbers), 0x004E4942) + places)
    file.write(numbers)


def write_3mf(file, vertices, corners):
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        archive.writestr("_rels/.rels", '<?xml version="1.0"?><Relationships><Relationship Target="/3D/3dmodel.model" Id="r" '
                         'Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')  # fmt: skip
        with archive.open("3D/3dmodel.model", "w") as part:
            part.write(b'<?xml version="1.0"?>\n<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">\n'
                       b'<resources><object id="1" type="model"><mesh>\n<vertices>\n')  # fmt: skip
            part.writelines(b'<vertex x="%.9g" y="%.9g" z="%.9g"/>\n' % v for v in triples(vertices))
            part.write(b"</vertices>\n<triangles>\n")
            part.writelines(b'<triangle v1="%d" v2="%d" v3="%d"/>\n' % t for t in triples(corners))
            part.write(b'</triangles>\n</mesh></object></resources>\n<build><item objectid="1"/></build></model>\n')


def write_vtk(file, vertices, corners):
    """Legacy, with numbers from the largest byte to the smallest."""
    swapped = array.array("f", vertices)
    swapped.byteswap()
    count = len(corners) // 3
    file.write(b"# vtk DataFile Version 3.0\nhorns\nBINARY\nDATASET POLYDATA\nPOINTS %d float\n" % (len(vertices) // 3))
    swapped.tofile(file)
    file.write(b"\nPOLYGONS %d %d\n" % (count, 4 * count))
    for a, b, c in triples(corners):
        file.write(struct.pack(">4i", 3, a, b, c))
    file.write(b"\n")


def write_vtp(file, vertices, corners):
    """Arrays as they are, behind the XML."""
    count = len(corners) // 3
    arrays = [("Points", "Float32", 3, vertices), ("connectivity", "UInt32", 1, corners), ("offsets", "UInt32", 1, array.array("I", range(3, 3 * count + 1, 3)))]
    tags, at = {}, 0
    for name, kind, width, numbers in arrays:
        tags[name] = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{width}" format="appended" offset="{at}"/>'
        at += 8 + 4 * len(numbers)
    file.write(
        f'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><PolyData><Piece '
        f'NumberOfPoints="{len(vertices) // 3}" NumberOfPolys="{count}"><Points>{tags["Points"]}</Points><Polys>{tags["connectivity"]}'
        f'{tags["offsets"]}</Polys></Piece></PolyData><AppendedData encoding="raw">_'.encode()
    )
    for *_, numbers in arrays:
        file.write(struct.pack("<Q", 4 * len(numbers)))
        numbers.tofile(file)
    file.write(b"</AppendedData></VTKFile>\n")


def write_collada(file, vertices, corners):
    file.write(b'<?xml version="1.0"?>\n<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><up_axis>Y_UP</up_axis>'
               b'</asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="%d">' % len(vertices))  # fmt: skip
    file.writelines(b"%.9g %.9g %.9g\n" % v for v in triples(vertices))
    file.write(b'</float_array><technique_common><accessor source="#a" count="%d" stride="3"><param name="X" type="float"/><param name="Y" '
               b'type="float"/><param name="Z" type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION" '
               b'source="#p"/></vertices><triangles count="%d"><input semantic="VERTEX" source="#v" offset="0"/><p>'
               % (len(vertices) // 3, len(corners) // 3))  # fmt: skip
    file.writelines(b"%d %d %d\n" % t for t in triples(corners))
    file.write(b'</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry '
               b'url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>\n')  # fmt: skip


def write_ac3d(file, vertices, corners):
    file.write(b'AC3Db\nMATERIAL "" rgb 1 1 1 amb 1 1 1 emis 0 0 0 spec 0 0 0 shi 0 trans 0\nOBJECT world\nkids 1\nOBJECT poly\nname "horns"\n'
               b'numvert %d\n' % (len(vertices) // 3))  # fmt: skip
    file.writelines(b"%.9g %.9g %.9g\n" % v for v in triples(vertices))
    file.write(b"numsurf %d\n" % (len(corners) // 3))
    file.writelines(b"SURF 0x0\nmat 0\nrefs 3\n%d 0 0\n%d 0 0\n%d 0 0\n" % t for t in triples(corners))
    file.write(b"kids 0\n")
