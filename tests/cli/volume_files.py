# SPDX-License-Identifier: MIT
# A small label volume, an ellipsoid, in every format that is read, made in code.
import gzip
import struct
import zlib

SIZE = (24, 16, 12)


def voxels():
    nx, ny, nz = SIZE
    inside = lambda x, y, z: sum(((c - (n - 1) / 2) / (0.42 * n)) ** 2 for c, n in zip((x, y, z), SIZE)) < 1
    return bytes(3 * inside(x, y, z) for z in range(nz) for y in range(ny) for x in range(nx))


def nifti():
    head = bytearray(352)
    struct.pack_into("<i", head, 0, 348)
    struct.pack_into("<8h", head, 40, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<2h", head, 70, 2, 8)
    struct.pack_into("<8f", head, 76, 1, 1, 1.5, 2, 0, 0, 0, 0)
    struct.pack_into("<f", head, 108, 352)
    struct.pack_into("<h", head, 254, 1)
    struct.pack_into("<12f", head, 280, 1, 0, 0, 5, 0, 1.5, 0, 6, 0, 0, 2, 7)
    head[344:348] = b"n+1\0"
    return bytes(head) + voxels()


def nifti2():
    head = bytearray(544)
    struct.pack_into("<i8s2h8q", head, 0, 540, b"n+2\0\r\n\x1a\n", 2, 8, 3, *SIZE, 1, 1, 1, 1)
    struct.pack_into("<8d", head, 104, 1, 1, 1.5, 2, 0, 0, 0, 0)
    struct.pack_into("<q", head, 168, 544)
    struct.pack_into("<i", head, 348, 1)
    struct.pack_into("<12d", head, 400, 1, 0, 0, 5, 0, 1.5, 0, 6, 0, 0, 2, 7)
    return bytes(head) + voxels()


def beside():
    """What the headers of nrrd_header() and metaimage_header() name."""
    return {"voxels.raw": voxels()}


def nrrd_header():
    return nrrd("raw")[: -len(voxels()) - 1] + b"data file: voxels.raw\n\n"


def metaimage_header():
    return metaimage(False)[: -len(voxels())].replace(b"LOCAL", b"voxels.raw")


def nrrd(encoding):
    header = f"NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: {SIZE[0]} {SIZE[1]} {SIZE[2]}\n"
    header += f"space directions: (1,0,0) (0,1.5,0) (0,0,2)\nencoding: {encoding}\nspace origin: (5,6,7)\n\n"
    return header.encode() + (gzip.compress(voxels(), mtime=0) if encoding == "gzip" else voxels())


def metaimage(compressed):
    content = zlib.compress(voxels()) if compressed else voxels()
    header = f"ObjectType = Image\nNDims = 3\nDimSize = {SIZE[0]} {SIZE[1]} {SIZE[2]}\nElementSpacing = 1 1.5 2\nOffset = 5 6 7\n"
    header += f"CompressedData = {compressed}\n" + (f"CompressedDataSize = {len(content)}\n" if compressed else "")
    return (header + "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n").encode() + content
