# SPDX-License-Identifier: MIT
# What `homolog transfer`, `dense` and `morph` read besides meshes: landmark files of every format, and the results of a match. Standard
# library only.
import json

CORNERS = [(1.5, 0.75, 0.25), (-1, 0, 0), (0, 1, 0)]  # of mesh_files.solid()


def markups():
    points = [{"id": str(i), "label": f"p{i}", "description": "", "position": place, "positionStatus": "defined"} for i, place in enumerate(CORNERS)]
    gone = {"id": "gone", "label": "gone", "positionStatus": "undefined"}
    return json.dumps({"markups": [{"type": "Curve", "coordinateSystem": "LPS", "coordinateUnits": "mm", "controlPoints": [*points, gone]}]})


def landmark_files():
    """The corners, and one that is missing, by file name."""
    rows = [" ".join(map(str, place)) for place in CORNERS]
    columns = "id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID"
    fcsv = [f"vtk_{i},{x},{y},{z},0,0,0,1,1,1,0,\"p, {i}\",," for i, (x, y, z) in enumerate(CORNERS)]
    texts = {
        "landmarks.csv": "label,x,y,z\n" + "".join(f'"p ""{i}""",{row.replace(" ", ",")}\n' for i, row in enumerate(rows)) + "gone,,NA,\n",
        "landmarks.mrk.json": markups(),
        "landmarks.fcsv": f"# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n# columns = {columns}\n" + "\n".join(fcsv) + "\n",
        "landmarks.pts": f"Version 1.0\n{len(rows) + 1}\n" + "".join(f"S{i:03} {row}\n" for i, row in enumerate([*rows, "9999 9999 9999"])),
        "landmarks.tps": f"LM3={len(rows) + 1}\n" + "\n".join([*rows, "NA NA NA"]) + "\nCURVES=1\nPOINTS=1\n0 0 1\nIMAGE=a.jpg\nID=a\nSCALE=1\n",
        "landmarks.txt": f"[individuals]\n1\n[landmarks]\n{len(rows)}\n[dimensions]\n3\n[names]\na\n[rawpoints]\n'a\n" + "\n".join(rows) + "\n",
    }  # fmt: skip
    return {name: text.encode() for name, text in texts.items()}
