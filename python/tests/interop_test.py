# SPDX-License-Identifier: MIT
"""Whatever holds a bear, its points are the same: a file, arrays of any kind, trimesh, PyVista."""
from types import SimpleNamespace

import homolog
import numpy as np
import pytest
import pyvista
import trimesh
from homolog import viz
from shapes import COARSE, bear_arrays, bytes_of, moved


@pytest.fixture(scope="module")
def points():
    return points_of(bear_arrays())


def points_of(shape):
    return bytes_of(homolog.points(shape, **COARSE))


def test_trimesh(points):
    mesh = trimesh.Trimesh(*bear_arrays(), process=False)
    assert points_of(mesh) == points
    assert points_of(trimesh.Scene(mesh)) == points


def test_a_similarity_moves_a_trimesh_onto_the_data():
    vertices, faces = bear_arrays()
    model, data = trimesh.Trimesh(vertices, faces, process=False), trimesh.Trimesh(moved(vertices), faces, process=False)
    best = homolog.match(model, data, **COARSE)[0]
    model.apply_transform(best.similarity)
    assert np.linalg.norm(model.vertices - data.vertices, axis=1).mean() < 0.02 * data.scale


def test_pyvista(points):
    vertices, faces = bear_arrays()
    mesh = pyvista.PolyData(vertices, np.insert(faces, 0, 3, axis=1).ravel())
    assert points_of(mesh) == points
    assert len(homolog.describe(mesh.cast_to_unstructured_grid(), **COARSE).faces) == len(faces)


def test_quads_of_pyvista_are_divided():
    mesh = pyvista.Box()
    assert mesh.regular_faces.shape == (6, 4)
    assert len(homolog.describe(mesh, resolution=32).faces) == 12


def test_vertices_and_triangles(points):
    vertices, faces = bear_arrays()
    assert points_of(SimpleNamespace(vertices=vertices, triangles=faces)) == points


def test_open3d(points):  # not of the test extra, for it brings half a gigabyte: pip install open3d-cpu
    open3d = pytest.importorskip("open3d")
    vertices, faces = bear_arrays()
    places, triangles = open3d.utility.Vector3dVector(vertices), open3d.utility.Vector3iVector(faces)
    model = open3d.geometry.TriangleMesh(places, triangles)
    assert points_of(model) == points
    family = homolog.match(model, (moved(vertices), faces), **COARSE)
    model.transform(family[0].similarity)
    assert np.linalg.norm(np.asarray(model.vertices) - moved(vertices), axis=1).mean() < 0.02 * np.linalg.norm(np.ptp(moved(vertices), axis=0))
    places.clear()
    places.extend(family.morph().end)
    assert open3d.geometry.TriangleMesh(places, triangles).get_surface_area() > 0


def test_path(points, tmp_path):
    vertices, faces = bear_arrays()
    rows = [f"{len(vertices)} {len(faces)} 0", *(" ".join(map(repr, map(float, v))) for v in vertices), *(f"3 {a} {b} {c}" for a, b, c in faces)]
    file = tmp_path / "b\u00e4r.off"
    file.write_text("\n".join(["OFF", *rows]))
    assert points_of(file) == points_of(str(file)) == points_of(bytes(file)) == points


@pytest.mark.parametrize("faces", [np.int32, np.int64, np.uint32, np.uint16, ">i4"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_of_any_kind_and_order(points, faces, order):
    vertices, triangles = bear_arrays()
    wide = np.zeros((2 * len(vertices), 4))
    wide[::2, 1:] = vertices
    assert points_of((wide[::2, 1:], np.array(triangles, faces, order=order))) == points
    assert points_of((np.array(vertices, ">f8", order=order), triangles.tolist())) == points


def test_single_precision_is_taken_as_it_is():
    vertices, faces = bear_arrays()
    single = vertices.astype(np.float32)
    assert points_of((single, faces)) == points_of((single.astype(float), faces))


def test_arrays_given_are_not_changed_nor_looked_at_again():
    vertices, faces = bear_arrays()
    before = vertices.copy()
    shape = homolog.describe((vertices, faces), **COARSE)
    np.testing.assert_array_equal(vertices, before)
    vertices[:] = 0
    np.testing.assert_array_equal(shape.vertices, before)


def test_a_match_is_drawn():
    vertices, faces = bear_arrays()
    family = homolog.match((vertices, faces), (moved(vertices), faces), **COARSE)
    np.testing.assert_array_equal(viz.mesh_of(family.model, family[0].model_part)["part"], family[0].model_part)
    picture = viz.plotter(family, off_screen=True).screenshot(return_img=True)
    assert len(np.unique(picture.reshape(-1, picture.shape[-1]), axis=0)) > 100
    with pytest.raises(ValueError, match="no match 99"):
        viz.plotter(family, 99)
