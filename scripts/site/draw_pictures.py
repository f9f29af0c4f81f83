# SPDX-License-Identifier: MIT
"""The pictures that are drawn rather than photographed: draw_pictures.py RUNS PICTURES SLICE.pgm STAGES.csv

RUNS are the folders that tests/docs/run_blocks.py keeps; the other two come from the programs of examples/.
"""
import csv
import json
import sys
from pathlib import Path

import matplotlib
import numpy as np
import pyvista

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

pyvista.OFF_SCREEN = True
RUNS, PICTURES = Path(sys.argv[1]), Path(sys.argv[2])
SKIN = {"color": "#d8d4cc", "smooth_shading": True}
GHOST = {**SKIN, "opacity": 0.35}
FRONT = {"vector": (0.25, 0.1, 1), "viewup": (0, 1, 0)}


class Panels:
    """Views side by side in one picture."""

    def __init__(self, count, height=460):
        self.plotter = pyvista.Plotter(shape=(1, count), window_size=(min(1400, 460 * count), height), border=False)
        self.next = 0

    def panel(self, *meshes, view=FRONT, zoom=1.3, title=""):
        """Each mesh is (mesh, how to draw it)."""
        self.plotter.subplot(0, self.next)
        self.next += 1
        for mesh, how in meshes:
            self.plotter.add_mesh(mesh, **how)
        if title:
            self.plotter.add_text(title, font_size=9, color="black")
        self.plotter.view_vector(**view)
        self.plotter.camera.zoom(zoom)

    def save(self, name):
        self.plotter.screenshot(PICTURES / name)
        self.plotter.close()


def off(path):
    numbers = path.read_text().split("\n", 1)[1].split()
    n, m = int(numbers[0]), int(numbers[1])
    places = np.array(numbers[3 : 3 + 3 * n], float).reshape(n, 3)
    return pyvista.PolyData.from_regular_faces(places, np.array(numbers[3 + 3 * n :], int).reshape(m, 4)[:, 1:])


def coloured(path):
    return pyvista.read(path), {"scalars": "RGB", "rgb": True, "smooth_shading": True}


def moved(mesh, places):
    copy = mesh.copy()
    copy.points = places
    return copy


def draw_dense_and_morph(bears):
    panels = Panels(2)
    for name in ("model", "data"):
        panels.panel(coloured(bears / f"bears/dense/{name}.dense.ply"), title=name)
    panels.save("tutorial_dense.png")
    panels = Panels(5, height=300)
    for number in range(1, 6):
        panels.panel((pyvista.read(bears / f"morph.{number}.ply"), SKIN))
    panels.save("tutorial_morph.png")


def warp(match, points):
    spline = match["warp"]
    distance = np.linalg.norm(points[:, None] - np.array(spline["centres"]), axis=2)
    return np.column_stack([points, np.ones(len(points))]) @ np.array(spline["affine"]).T + distance @ np.array(spline["weights"])


def draw_refinement(bears):
    match = json.loads((bears / "bears/match.json").read_text())["matches"][0]
    model, data = off(bears / "bear.off"), off(bears / "bear_bis.off")
    similarity = np.array(match["data_from_model"])
    laid = model.points @ similarity[:3, :3].T + similarity[:3, 3]
    panels = Panels(2)
    for places, title in ((laid, "turned and scaled"), (warp(match, np.array(model.points)), "by the refined map")):
        panels.panel((data, GHOST), (moved(model, places), {"color": "teal", "opacity": 0.6, "smooth_shading": True}), zoom=1.1, title=title)
    panels.save("refinement.png")


def draw_points(folder):
    panels = Panels(1)
    points = json.loads((folder / "points/points.json").read_text())["shape"]["points"]
    balls = [(pyvista.Sphere(p["radius"], p["position"]), {"color": "teal", "opacity": 0.6, "smooth_shading": True}) for p in points]
    panels.panel((off(folder / "bear.off"), {**SKIN, "opacity": 0.25}), *balls)
    panels.save("salient_points.png")


def draw_symmetry(folder):
    mesh = off(folder / "bear.off")
    found = json.loads((folder / "self/symmetry.json").read_text())["symmetries"][0]
    normal = np.array(found["normal"])
    middle = np.array(mesh.center) + (found["offset"] - normal @ mesh.center) * normal
    plane = pyvista.Plane(center=middle, direction=normal, i_size=mesh.length * 0.75, j_size=mesh.length * 0.75)
    panels = Panels(1)
    panels.panel((mesh, SKIN), (plane, {"color": "teal", "opacity": 0.4}), view={"vector": (0.8, 0.25, 1), "viewup": (0, 1, 0)}, zoom=1.1)
    panels.save("symmetry.png")


def draw_bones(folder):
    names = ["femur", "slender", "bent", "left", "broken"]
    panels = Panels(len(names), height=360)
    for name in names:
        mesh = off(folder / ("femur.off" if name == "femur" else f"specimens/{name}.off"))
        file = folder / ("template.mrk.json" if name == "femur" else f"specimens/{name}.mrk.json")
        points = json.loads(file.read_text())["markups"][0]["controlPoints"]
        marks = [(n, p["position"]) for n, p in enumerate(points) if p["positionStatus"] == "defined"]
        colours = pyplot.get_cmap("tab10")
        balls = [(pyvista.Sphere(0.025 * mesh.length, place), {"color": colours(n)}) for n, place in marks]
        axes = np.linalg.svd(np.array(mesh.points) - mesh.center, full_matrices=False)[2]
        panels.panel((mesh, GHOST), *balls, view={"vector": axes[2], "viewup": axes[0]}, title="template" if name == "femur" else name)
    panels.save("bones.png")


def draw_assembly(folder):
    panels = Panels(2)
    panels.panel(coloured(folder / "joint/model.part.ply"), view={"vector": (1, 1, 1), "viewup": (0, 0, 1)}, zoom=0.9, title="part")
    panels.panel(coloured(folder / "joint/data.part.ply"), view={"vector": (-0.6, 0.5, 1), "viewup": (0, 1, 0)}, title="assembly")
    panels.save("assembly.png")


def textured(folder, name):
    """The parts of an .obj with how to draw them: textured, or pale where nothing was carried."""
    mesh = pyvista.read(folder / f"{name}.obj")
    names = list(mesh.field_data["MaterialNames"])
    has_uvs = mesh.cell_data["MaterialIds"] != (names.index("not_carried") if "not_carried" in names else -1)
    texture = {"texture": pyvista.read_texture(folder / "squares.png")}
    parts = ((has_uvs, texture), (~has_uvs, SKIN))
    return [(mesh.extract_cells(np.flatnonzero(which)).extract_surface(), how) for which, how in parts if which.any()]


def draw_uvs(folder):
    panels = Panels(2, height=560)
    for name, view in (("man", {"vector": (-1, 1, 0.1), "viewup": (0, 0, 1)}), ("armadillo", {"vector": (-0.2, 0.1, 1), "viewup": (0, 1, 0)})):
        panels.panel(*textured(folder, name), view=view, zoom=1.2, title=name)
    panels.save("uvs.png")


def draw_voxels(slice_path):
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 4.2), width_ratios=[1, 1])
    picture = pyplot.imread(slice_path)
    height, width = picture.shape
    for axis, part in ((axes[0], picture), (axes[1], picture[: height // 3, width // 2 : width // 2 + height // 3])):
        axis.imshow(part, cmap="gray", vmin=0, vmax=255, interpolation="nearest")
        axis.set_axis_off()
    figure.savefig(PICTURES / "voxels.png", dpi=110, bbox_inches="tight")


def draw_descriptors(rows):
    candidates = [row for row in rows if row["stage"] == "candidate"]
    table = np.full([1 + max(int(row[name]) for row in candidates) for name in ("model", "data")], np.nan)
    for row in candidates:
        table[int(row["model"]), int(row["data"])] = float(row["distance"])
    figure, axis = pyplot.subplots(figsize=(4.6, 4))
    figure.colorbar(axis.imshow(table, cmap="viridis"), label="distance")
    right = [(int(row["model"]), int(row["data"])) for row in rows if row["stage"] == "match"]
    axis.scatter([data for _, data in right], [model for model, _ in right], s=160, facecolors="none", edgecolors="red", linewidths=2)
    axis.set(xlabel="points of the data", ylabel="points of the model")
    figure.savefig(PICTURES / "descriptors.png", dpi=110, bbox_inches="tight")


def draw_pairs(bears, rows, stages, name):
    model, data = off(bears / "bear.off"), off(bears / "bear_bis.off")
    aside = np.array([1.25 * np.ptp(model.points, axis=0).max(), 0, 0])
    panels = Panels(len(stages))
    for stage in stages:
        lines = [
            (pyvista.Line(place("model", row), place("data", row) + aside), {"color": "teal", "line_width": 1 if stage == "candidate" else 4})
            for row in rows if row["stage"] == stage
        ]  # fmt: skip
        panels.panel((model, GHOST), (moved(data, data.points + aside), GHOST), *lines, view={"vector": (0, 0, 1), "viewup": (0, 1, 0)}, zoom=1)
    panels.save(name)


def place(side, row):
    return np.array([float(row[f"{side}_{axis}"]) for axis in "xyz"])


def main():
    pyvista.global_theme.background = "white"
    bears = RUNS / "tutorial"
    with open(sys.argv[4], newline="") as file:
        rows = list(csv.DictReader(file))
    draw_dense_and_morph(bears)
    draw_refinement(bears)
    draw_points(RUNS / "salient_points")
    draw_symmetry(RUNS / "symmetry")
    draw_bones(RUNS / "bones")
    draw_assembly(RUNS / "assembly")
    draw_uvs(RUNS / "uvs")
    draw_voxels(sys.argv[3])
    draw_descriptors(rows)
    draw_pairs(bears, rows, ["candidate", "seed"], "seeds.png")
    draw_pairs(bears, rows, ["grown"], "growth.png")


main()
