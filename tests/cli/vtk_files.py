# SPDX-License-Identifier: MIT
# VTK files of a mesh, legacy and XML. Standard library only.
import base64
import struct
import zlib


def lines(*some):
    return ("\n".join(some) + "\n").encode()


def vtk(v, f, binary):
    """Legacy VTK."""
    head = f"# vtk DataFile Version 3.0\nit\n{'BINARY' if binary else 'ASCII'}\nDATASET POLYDATA\nPOINTS {len(v)} double\n".encode()
    cells = f"\nPOLYGONS {len(f)} {4 * len(f)}\n".encode()
    if not binary:
        return head + lines(*("%r %r %r" % x for x in v)) + cells + lines(*("3 %d %d %d" % t for t in f))
    return head + b"".join(struct.pack(">3d", *x) for x in v) + cells + b"".join(struct.pack(">4i", 3, *t) for t in f) + b"\n"


def vtp(v, f, form):
    """VTK's XML: form is ascii, binary (base64) or appended (raw, compressed)."""
    data = [("Points", "Float64", struct.pack(f"<{3 * len(v)}d", *(c for x in v for c in x))),
            ("connectivity", "Int64", struct.pack(f"<{3 * len(f)}q", *(i for t in f for i in t))),
            ("offsets", "Int64", struct.pack(f"<{len(f)}q", *range(3, 3 * len(f) + 1, 3)))]  # fmt: skip
    arrays, appended = [], b""
    for name, kind, content in data:
        tag = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{3 if name == "Points" else 1}" format="{form}"'
        if form == "ascii":
            numbers = struct.unpack(f"<{len(content) // 8}{'d' if kind == 'Float64' else 'q'}", content)
            arrays.append(f"{tag}>{' '.join(map(repr, numbers))}</DataArray>")
        elif form == "binary":
            arrays.append(f"{tag}>{base64.b64encode(struct.pack('<I', len(content)) + content).decode()}</DataArray>")
        else:
            arrays.append(f'{tag} offset="{len(appended)}"/>')
            packed = zlib.compress(content)
            appended += struct.pack("<4I", 1, len(content), 0, len(packed)) + packed
    compressor = ' compressor="vtkZLibDataCompressor"' if form == "appended" else ""
    text = (
        f'<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian" header_type="UInt32"{compressor}>\n<PolyData>'
        f'<Piece NumberOfPoints="{len(v)}" NumberOfPolys="{len(f)}">\n<Points>{arrays[0]}</Points>\n<Polys>{arrays[1]}{arrays[2]}</Polys></Piece></PolyData>'
    ).encode()
    return text + (b'<AppendedData encoding="raw">_' + appended + b"</AppendedData>" if appended else b"") + b"</VTKFile>\n"


def vtu(v, f):
    """An unstructured grid of triangles, as VTK's XML in text."""
    def array(name, kind, numbers):
        return f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{3 if name == "Points" else 1}" format="ascii">{" ".join(map(repr, numbers))}</DataArray>'

    cells = array("connectivity", "Int64", [i for t in f for i in t]) + array("offsets", "Int64", [3 * i + 3 for i in range(len(f))])
    return (
        f'<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">\n<UnstructuredGrid>'
        f'<Piece NumberOfPoints="{len(v)}" NumberOfCells="{len(f)}">\n<Points>{array("Points", "Float64", [c for x in v for c in x])}</Points>\n'
        f'<Cells>{cells}{array("types", "UInt8", [5] * len(f))}</Cells></Piece></UnstructuredGrid></VTKFile>\n'
    ).encode()
