#!/usr/bin/env python3
"""How well a skin is carried: a rigged .glb and the same mesh posed otherwise, vertex for vertex.

    python3 bench/carried_rig.py build/release/cli/homolog RIGGED.glb POSED.glb

Matches the two, carries the rig of the first to the second by `homolog transfer`, and tells how far weights and joints are from the truth:
vertex i of POSED has the weights of vertex i of RIGGED, and a joint goes where the best rigid motion of the vertices that follow it takes
it, each counted by its squared weight. Needs numpy, and files whose first mesh is the one and whose mesh nodes stand still. Written for the hands of the npm
package @webxr-input-profiles/assets: generic-hand/right.glb and generic-fixed-hand/right.glb.
"""
import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

COMPONENTS = {5121: np.uint8, 5123: np.uint16, 5125: np.uint32, 5126: np.float32}
COLUMNS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class Glb:
    """The first mesh of a file, and its first skin."""

    def __init__(self, path):
        content = Path(path).read_bytes()
        size = struct.unpack_from("<I", content, 12)[0]
        self.scene, self.buffer = json.loads(content[20 : 20 + size]), content[28 + size :]
        attributes = self.scene["meshes"][0]["primitives"][0]["attributes"]
        self.places = self.table(attributes["POSITION"])
        self.weights = self.names = self.binds = None
        if "JOINTS_0" not in attributes:
            return
        skin = self.scene["skins"][0]
        self.names = [self.scene["nodes"][joint]["name"] for joint in skin["joints"]]
        self.binds = np.linalg.inv(self.table(skin["inverseBindMatrices"]).reshape(-1, 4, 4).transpose(0, 2, 1))
        self.weights = np.zeros((len(self.places), len(self.names)))
        for joints, weights in zip(self.table(attributes["JOINTS_0"]).T, self.table(attributes["WEIGHTS_0"]).T):
            np.add.at(self.weights, (np.arange(len(joints)), joints.astype(int)), weights)

    def table(self, number):
        accessor = self.scene["accessors"][number]
        view = self.scene["bufferViews"][accessor["bufferView"]]
        start, columns = view.get("byteOffset", 0) + accessor.get("byteOffset", 0), COLUMNS[accessor["type"]]
        values = np.frombuffer(self.buffer, COMPONENTS[accessor["componentType"]], accessor["count"] * columns, start)
        return values.reshape(-1, columns).astype(float)


def carry(program, rigged, posed, folder):
    for words in (["match", rigged, posed, "--out", folder / "match"],
                  ["transfer", folder / "match" / "match.json", "--attributes", rigged, "--onto", posed, "--out", folder / "carried.glb"]):  # fmt: skip
        subprocess.run([program, *words, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    return Glb(folder / "carried.glb")


def rigid(sources, targets, weights):
    """The rotation and the shift that take sources to targets best."""
    a, b = weights @ sources / weights.sum(), weights @ targets / weights.sum()
    u, _, v = np.linalg.svd(((targets - b).T * weights) @ (sources - a))
    turn = u @ np.diag([1, 1, np.linalg.det(u @ v)]) @ v
    return turn, b - turn @ a


def main():
    program, rigged, posed = sys.argv[1], Glb(sys.argv[2]), Glb(sys.argv[3])
    with tempfile.TemporaryDirectory() as folder:
        carried = carry(program, sys.argv[2], sys.argv[3], Path(folder))
    diagonal = np.linalg.norm(np.ptp(posed.places, axis=0))
    number = {tuple(place): i for i, place in enumerate(posed.places)}
    if not all(tuple(place) in number for place in carried.places):
        sys.exit("the carried mesh has vertices elsewhere than the posed one; do the nodes of the meshes stand still?")
    truth = rigged.weights[[number[tuple(place)] for place in carried.places]]
    wrong = np.abs(truth - carried.weights).sum(axis=1) / 2
    same = (truth.argmax(axis=1) == carried.weights.argmax(axis=1)).mean()
    print(f"weights: {wrong.mean():.3f} of a vertex's on other joints in the mean, {np.quantile(wrong, 0.95):.3f} at 95 %; the strongest joint is the same for {same:.1%}")
    rows = []
    for joint, name in enumerate(rigged.names):
        if not rigged.weights[:, joint].any():
            continue
        turn, shift = rigid(rigged.places, posed.places, rigged.weights[:, joint] ** 2)
        place, frame = turn @ rigged.binds[joint][:3, 3] + shift, turn @ rigged.binds[joint][:3, :3]
        cosine = (np.trace(frame.T @ carried.binds[joint][:3, :3]) - 1) / 2
        moved = np.linalg.norm(place - rigged.binds[joint][:3, 3]) / diagonal
        rows.append((np.linalg.norm(place - carried.binds[joint][:3, 3]) / diagonal, np.degrees(np.arccos(np.clip(cosine, -1, 1))), moved))
        print(f"{name:36} off by {rows[-1][0]:.4f} diagonals and {rows[-1][1]:5.1f} degrees; had to go {moved:.3f}")
    off, turned, moved = np.array(rows).T
    print(f"joints: off by {np.median(off):.4f} diagonals in the median, {off.max():.4f} at most; {np.median(turned):.1f} degrees, {turned.max():.1f} at most")


if __name__ == "__main__":
    main()
