#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Individuals of kinds that are hard to come by with truth: planes, ants, birds, fish, chairs, pliers, octopuses and quadrupeds.

usage: kinds.py OUT [SEED]        (needs numpy and scikit-image)

Every individual is a skeleton of tapered, flattened capsules, of which lengths, widths, places, angles and some parts are drawn by chance,
blended to one solid. Landmarks lie around every capsule. OUT becomes a folder for bench_accuracy OUT: five individuals a kind, ten pairs.
"""
import os
import sys
from dataclasses import dataclass, field

import numpy as np
from skimage import measure

INDIVIDUALS, PARTNERS = 5, (1, 2)  # individual i is matched with i + 1 and i + 2
CELLS = 110  # of the grid along the longest side
BLEND = 0.12  # within which two capsules flow into each other
SPREAD = 0.22  # of the logarithm of lengths and widths
SEEN = 0.012  # diagonals: landmarks deeper inside are left out


@dataclass
class Bone:
    """Grows from a share of its parent, off by `off`, along `way`; lengths in no unit. x is to the left, y forwards, z up."""

    name: str
    parent: str | None
    share: float
    off: tuple
    way: tuple
    length: float
    radii: tuple  # at both ends
    flat: tuple = (1, 1)  # widths across, in shares of the radius
    pose: float = 15  # degrees by which individuals turn it
    paired: bool = False  # a left and a right one
    up: tuple = (0, 0, 1)


def plane(draw):
    yield Bone("fuselage", None, 0, (0, 0, 0), (0, 1, 0), 10, (0.7, 0.5), pose=0)
    yield Bone("nose", "fuselage", 1, (0, 0, 0), (0, 1, 0), 1, (0.5, 0.2), pose=0)
    yield Bone("wing", "fuselage", 0.55, (0.4, 0, -0.1), (1, -0.35, 0.05), 6, (1, 0.5), (1, 0.16), 0, True)
    yield Bone("tailplane", "fuselage", 0.05, (0.2, 0, 0.2), (1, -0.4, 0), 2.2, (0.6, 0.35), (1, 0.18), 0, True)
    yield Bone("fin", "fuselage", 0.05, (0, 0, 0.3), (0, -0.5, 1), 2, (0.7, 0.4), (0.18, 1), 0, up=(0, 1, 0))
    if draw.random() < 0.6:
        yield Bone("engine", "wing", 0.35, (0, 0.6, -0.35), (0, 1, 0), 1.2, (0.35, 0.3), pose=0, paired=True)


def ant(draw):
    yield Bone("thorax", None, 0, (0, 0, 0), (0, 1, 0), 2, (0.45, 0.5), pose=0)
    yield Bone("abdomen", "thorax", 0, (0, -0.2, 0), (0, -1, 0.1), 2.6, (0.4, 0.9))
    yield Bone("head", "thorax", 1, (0, 0.2, 0.1), (0, 1, 0), 1, (0.4, 0.6))
    yield Bone("scape", "head", 0.8, (0.3, 0.2, 0.3), (0.5, 1, 0.7), 1.3, (0.12, 0.12), paired=True)
    yield Bone("feeler", "scape", 1, (0, 0, 0), (0.3, 1, -0.3), 1.5, (0.12, 0.1), pose=25, paired=True)
    for name, share, y in (("front", 0.95, 0.9), ("middle", 0.5, 0), ("hind", 0.05, -0.9)):
        yield Bone(name + "_thigh", "thorax", share, (0.3, 0, -0.2), (1, y, 0.5), 1.9, (0.17, 0.14), paired=True)
        yield Bone(name + "_shin", name + "_thigh", 1, (0, 0, 0), (0.7, 0.8 * y, -1), 2.3, (0.14, 0.1), pose=20, paired=True)


def bird(draw):
    yield Bone("body", None, 0, (0, 0, 0), (0, 1, 0.15), 3, (0.7, 0.8), pose=0)
    yield Bone("neck", "body", 1, (0, 0, 0.3), (0, 0.8, 1), 1, (0.4, 0.35))
    yield Bone("head", "neck", 1, (0, 0, 0.1), (0, 1, 0.1), 0.6, (0.42, 0.36))
    yield Bone("beak", "head", 1, (0, 0.2, 0), (0, 1, -0.1), 0.7, (0.2, 0.06), pose=5)
    yield Bone("tail", "body", 0, (0, -0.2, 0), (0, -1, 0.1), 2, (0.5, 0.8), (1, 0.2), 8)
    yield Bone("arm", "body", 0.7, (0.5, 0, 0.3), (1, 0.1, 0.2), 2.6, (0.8, 0.75), (1, 0.16), 25, True)
    yield Bone("pinion", "arm", 1, (0, 0, 0), (1, -0.5, -0.1), 2.8, (0.75, 0.35), (1, 0.16), 20, True)
    yield Bone("leg", "body", 0.35, (0.35, 0, -0.5), (0, 0.1, -1), 1.6, (0.2, 0.14), pose=20, paired=True)
    yield Bone("foot", "leg", 1, (0, 0, 0), (0, 1, -0.1), 0.8, (0.14, 0.12), paired=True)


def fish(draw):
    upright = {"up": (0, 1, 0)}
    yield Bone("trunk", None, 0, (0, 0, 0), (0, 1, 0), 2.2, (0.9, 0.75), (0.55, 1), 0)
    yield Bone("head", "trunk", 1, (0, 0, 0), (0, 1, 0), 1.3, (0.75, 0.3), (0.6, 1), 5)
    yield Bone("stem", "trunk", 0, (0, 0, 0), (0, -1, 0), 2.4, (0.9, 0.3), (0.5, 1), 15)
    yield Bone("upper_lobe", "stem", 1, (0, 0, 0), (0, -0.8, 1), 1.6, (0.35, 0.3), (0.25, 1), 6, **upright)
    yield Bone("lower_lobe", "stem", 1, (0, 0, 0), (0, -0.8, -1), 1.6, (0.35, 0.3), (0.25, 1), 6, **upright)
    yield Bone("back_fin", "trunk", 0.3, (0, 0, 0.7), (0, -0.5, 1), 1.1, (0.7, 0.3), (0.2, 1), 5, **upright)
    yield Bone("side_fin", "trunk", 0.8, (0.4, 0, -0.3), (1, -0.8, -0.4), 1.3, (0.4, 0.3), (1, 0.25), 15, True)
    yield Bone("belly_fin", "stem", 0.35, (0, 0, -0.4), (0, -0.6, -1), 0.8, (0.4, 0.2), (0.3, 1), 5, **upright)


def chair(draw):
    yield Bone("seat", None, 0, (0, -1.4, 0), (0, 1, 0), 2.8, (1.6, 1.6), (1, 0.16), 0)
    yield Bone("back", "seat", 0, (0, 0, 0.1), (0, -0.15, 1), 3.4, (1.4, 1.3), (1, 0.16), 3, up=(0, 1, 0))
    yield Bone("front_leg", "seat", 0.95, (1.2, 0, -0.1), (0.08, 0.1, -1), 3, (0.22, 0.2), pose=3, paired=True)
    yield Bone("hind_leg", "seat", 0.05, (1.2, 0, -0.1), (0.08, -0.1, -1), 3, (0.22, 0.2), pose=3, paired=True)
    if draw.random() < 0.6:
        yield Bone("post", "seat", 0.8, (1.45, 0, 0.1), (0, 0, 1), 1.4, (0.18, 0.18), pose=2, paired=True)
        yield Bone("rest", "post", 1, (0, 0, 0), (0, -1, 0), 2.1, (0.2, 0.2), pose=2, paired=True)


def plier(draw):
    yield Bone("pivot", None, 0, (0, -0.3, 0), (0, 1, 0), 0.6, (0.6, 0.6), (1, 0.5), 0)
    yield Bone("jaw", "pivot", 1, (0.18, 0, 0), (0.15, 1, 0), 1.8, (0.4, 0.18), (1, 0.7), 6, True)
    yield Bone("shank", "pivot", 0, (0.2, 0, 0), (0.5, -1, 0), 1.8, (0.35, 0.3), pose=8, paired=True)
    yield Bone("handle", "shank", 1, (0, 0, 0), (0.05, -1, 0), 3.4, (0.32, 0.3), pose=6, paired=True)


def octopus(draw):
    yield Bone("mantle", None, 0, (0, 0, 0), (0, -0.3, 1), 1.6, (0.8, 1.1))
    for i in range(4):
        x, y = np.sin(np.radians(22.5 + 45 * i)), np.cos(np.radians(22.5 + 45 * i))
        yield Bone(f"arm{i}", "mantle", 0, (0.5 * x, 0.5 * y, -0.2), (x, y, -0.3), 2.2, (0.32, 0.24), pose=25, paired=True)
        yield Bone(f"tip{i}", f"arm{i}", 1, (0, 0, 0), (x, y, 0.1), 2.4, (0.24, 0.12), pose=40, paired=True)


def quadruped(draw):
    yield Bone("trunk", None, 0, (0, 0, 0), (0, 1, 0), 4, (0.9, 1), pose=0)
    yield Bone("neck", "trunk", 1, (0, 0.2, 0.4), (0, 1, 1), 1.6, (0.55, 0.45))
    yield Bone("head", "neck", 1, (0, 0, 0), (0, 1, -0.3), 1.3, (0.5, 0.3))
    yield Bone("ear", "head", 0, (0.3, 0, 0.3), (0.5, -0.2, 1), 0.5, (0.2, 0.1), pose=8, paired=True)
    for name, share in (("front", 0.95), ("hind", 0.05)):
        yield Bone(name + "_thigh", "trunk", share, (0.5, 0, -0.4), (0.1, 0, -1), 1.6, (0.42, 0.3), pose=22, paired=True)
        yield Bone(name + "_shin", name + "_thigh", 1, (0, 0, 0), (0, 0.05, -1), 1.5, (0.28, 0.2), paired=True)
        yield Bone(name + "_foot", name + "_shin", 1, (0, 0, 0), (0, 1, -0.2), 0.35, (0.22, 0.18), pose=5, paired=True)
    yield Bone("tail", "trunk", 0, (0, -0.2, 0.5), (0, -1, -0.3), 2, (0.22, 0.12), pose=30)


KINDS = (plane, ant, bird, fish, chair, plier, octopus, quadruped)


@dataclass
class Capsule:
    """A bone of one individual where it lies: `rest` and `frame` hold its axes in columns, before and after posing; the third runs along it."""

    start: np.ndarray
    rest: np.ndarray
    pose: np.ndarray
    length: float
    radii: np.ndarray
    flat: np.ndarray
    width: float
    frame: np.ndarray = field(init=False)

    def __post_init__(self):
        self.frame = self.pose @ self.rest

    def radius(self, share):
        return self.radii[0] + (self.radii[1] - self.radii[0]) * share

    def distance(self, places):
        """Signed, exact to first order near the surface."""
        local = (places - self.start) @ self.frame
        share = np.clip(local[:, 2] / self.length, 0, 1)
        across = np.stack([local[:, 0] / self.flat[0], local[:, 1] / self.flat[1], local[:, 2] - share * self.length], 1)
        size = np.linalg.norm(across, axis=1)
        slope = np.linalg.norm(across / np.array([*self.flat, 1]), axis=1) / np.maximum(size, 1e-9)
        return (size - self.radius(share)) / np.maximum(slope, 1e-6)

    def landmarks(self):
        for share in (0.15, 0.5, 0.85):
            for number, (x, y) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1))):
                local = np.array([x * self.flat[0], y * self.flat[1], 0]) * self.radius(share)
                yield f"{share:g}.{number}", self.start + self.frame @ (local + [0, 0, share * self.length])
        yield "1.9", self.start + self.frame @ [0, 0, self.length + self.radii[1]]


def turned(axis, degrees):
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(np.radians(degrees)) * cross + (1 - np.cos(np.radians(degrees))) * cross @ cross


def axes_along(way, up):
    z = way / np.linalg.norm(way)
    y = np.array(up, float) - z * (np.array(up) @ z)
    if np.linalg.norm(y) < 1e-6:
        y = np.array([0, 1, 0]) - z * z[1]
    y /= np.linalg.norm(y)
    return np.stack([np.cross(y, z), y, z], 1)


def individual(kind, draw):
    capsules = {}
    girth = np.exp(draw.normal(0, SPREAD / 2))
    for bone in kind(draw):
        longer, wider = np.exp(draw.normal(0, SPREAD)), np.exp(draw.normal(0, SPREAD)) * girth
        sideways = np.array([1 if bone.paired else 0, 1, 1])
        way = np.array(bone.way, float) / np.linalg.norm(bone.way) + 0.08 * draw.normal(size=3) * sideways
        share = np.clip(bone.share + draw.normal(0, 0.03), 0, 1)
        for side, sign in (("_L", 1), ("_R", -1)) if bone.paired else (("", 1),):
            mirror = np.diag([sign, 1, 1])
            start, pose = np.zeros(3), np.eye(3)
            if bone.parent:
                parent = capsules.get(bone.parent + side) or capsules[bone.parent]
                pose = parent.pose
                start = parent.start + pose @ (parent.rest[:, 2] * parent.length * share + mirror @ np.array(bone.off) * parent.width)
            if bone.pose:
                pose = turned(draw.normal(size=3), np.clip(draw.normal(0, bone.pose), -2 * bone.pose, 2 * bone.pose)) @ pose
            capsules[bone.name + side] = Capsule(start, mirror @ axes_along(way, bone.up), pose, bone.length * longer,
                                                 np.array(bone.radii) * wider, np.array(bone.flat), wider)
    return capsules


def distance(capsules, places):
    total = np.full(len(places), 1e9)
    for capsule in capsules.values():
        one = capsule.distance(places)
        overlap = np.maximum(BLEND - np.abs(total - one), 0) / BLEND
        total = np.minimum(total, one) - overlap * overlap * BLEND / 4
    return total


def surface(capsules):
    ends = [(c.start + c.frame[:, 2] * c.length * t, c.radii.max()) for c in capsules.values() for t in (0, 1)]
    low = np.min([place - radius for place, radius in ends], 0) - 0.2
    high = np.max([place + radius for place, radius in ends], 0) + 0.2
    cell = (high - low).max() / CELLS
    counts = np.ceil((high - low) / cell).astype(int) + 1
    grid = np.stack(np.meshgrid(*[low[a] + cell * np.arange(counts[a]) for a in range(3)], indexing="ij"), -1).reshape(-1, 3)
    values = np.concatenate([distance(capsules, some) for some in np.array_split(grid, 20)]).reshape(counts)
    vertices, faces, _, _ = measure.marching_cubes(values, 0)
    vertices = vertices * cell + low
    volume = np.einsum("ij,ij->i", vertices[faces[:, 0]], np.cross(vertices[faces[:, 1]], vertices[faces[:, 2]])).sum()
    return vertices, faces if volume > 0 else faces[:, ::-1]


def partner(name):
    """The landmark's mirror image: the other side's, or the one across the middle plane."""
    bone, rest = name.split(".", 1)
    if bone.endswith(("_L", "_R")):
        return bone[:-1] + ("R" if bone[-1] == "L" else "L") + "." + rest
    return name[:-1] + {"0": "2", "2": "0"}.get(name[-1], name[-1])


def seen_landmarks(capsules, diagonal):
    places = {f"{name}.{where}": place for name, capsule in capsules.items() for where, place in capsule.landmarks()}
    near = np.abs(distance(capsules, np.array(list(places.values())))) < SEEN * diagonal
    seen = {name for name, is_near in zip(places, near) if is_near}
    return {name: place for name, place in places.items() if name in seen and partner(name) in seen}


def write(path, capsules):
    vertices, faces = surface(capsules)
    with open(path + ".off", "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        file.writelines("%.6g %.6g %.6g\n" % tuple(v) for v in vertices)
        file.writelines("3 %d %d %d\n" % tuple(f) for f in faces)
    landmarks = seen_landmarks(capsules, np.linalg.norm(np.ptp(vertices, axis=0)))
    with open(path + ".landmarks.txt", "w", encoding="ascii") as file:
        file.writelines("%s %g %g %g\n" % (name, *place) for name, place in landmarks.items())
    number = {name: i for i, name in enumerate(landmarks)}
    pairs = {tuple(sorted({i, number[partner(name)]})) for name, i in number.items()}
    with open(path + ".symmetry.txt", "w", encoding="ascii") as file:
        file.writelines(" ".join(map(str, pair)) + "\n" for pair in sorted(pairs))


def main(out, seed):
    draw = np.random.default_rng(seed)
    rows = ["task\tmodel\tdata\tground_truth\tsimilarity_residual\tnote"]
    for kind in KINDS:
        name = kind.__name__
        os.makedirs(os.path.join(out, name), exist_ok=True)
        for i in range(INDIVIDUALS):
            write(os.path.join(out, name, f"{name}{i}"), individual(kind, draw))
            for step in PARTNERS:
                rows.append(f"whole\t{name}/{name}{i}\t{name}/{name}{(i + step) % INDIVIDUALS}\tlandmarks, left/right swap allowed\t-\t")
    with open(os.path.join(out, "pairs.tsv"), "w", encoding="ascii") as file:
        file.write("\n".join(rows) + "\n")
    print(f"{len(rows) - 1} pairs in {out}")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) == 3 else 1)
