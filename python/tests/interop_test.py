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


@pytest.mark.parametrize("name", ["bear.vtk", "bear.vtp", "bear.vtu"])
@pytest.mark.parametrize("binary", [True, False])
def test_files_of_vtk(tmp_path, points, name, binary):
    vertices, faces = bear_arrays()
    mesh = pyvista.PolyData(vertices, np.insert(faces, 0, 3, axis=1).ravel())
    mesh["height"] = vertices[:, 1]
    mesh.field_data["time"] = [1.5]
    if name.endswith("vtu"):
        mesh = mesh.cast_to_unstructured_grid()
    mesh.save(tmp_path / name, binary=binary)
    described = homolog.describe(tmp_path / name, **COARSE)
    np.testing.assert_allclose(described.vertices, vertices, atol=1e-5 if not binary else 0)  # text has six digits
    np.testing.assert_array_equal(described.faces, faces)
    assert not binary or bytes_of(described.points) == points


def test_files_of_vtk_compressed_inside_and_appended(tmp_path):
    vtk = pytest.importorskip("vtkmodules.vtkIOXML", exc_type=ImportError)
    vertices, faces = bear_arrays()
    mesh = pyvista.PolyData(vertices, np.insert(faces, 0, 3, axis=1).ravel())
    for mode in ("SetDataModeToAppended", "SetDataModeToBinary"):
        for compressor in ("SetCompressorTypeToZLib", "SetCompressorTypeToNone"):
            for encode in (True, False):
                writer = vtk.vtkXMLPolyDataWriter()
                writer.SetFileName(str(tmp_path / "bear.vtp"))
                writer.SetInputData(mesh)
                getattr(writer, mode)()
                getattr(writer, compressor)()
                writer.SetEncodeAppendedData(encode)
                writer.SetByteOrderToBigEndian()
                assert writer.Write()
                described = homolog.describe(tmp_path / "bear.vtp", resolution=32)
                np.testing.assert_array_equal(described.vertices, vertices)
                np.testing.assert_array_equal(described.faces, faces)


def test_a_label_of_a_volume_and_limits(tmp_path):
    voxels = np.zeros((20, 20, 20), np.uint8)
    voxels[2:8, 2:8, 2:8], voxels[10:18, 2:8, 2:8] = 1, 2
    path = tmp_path / "labels.nrrd"
    head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 20 20 20\nencoding: raw\nspace: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n\n"
    path.write_bytes(head.encode() + voxels.tobytes())  # the last index is the first axis of the file
    one, two = (homolog.describe(path, label=label, resolution=32) for label in (1, 2))
    assert np.ptp(one.vertices, axis=0)[2] < np.ptp(two.vertices, axis=0)[2]
    assert len(homolog.describe(path, label=0, resolution=32).vertices) == len(one.vertices) + len(two.vertices)
    with pytest.raises(OSError, match="say which one is meant"):
        homolog.points(path)
    with pytest.raises(OSError, match="no label 3"):
        homolog.symmetry(path, label=3)
    with pytest.raises(OSError, match="are more than the 100 that are read"):
        homolog.describe(path, label=1, max_voxels=100)
    with pytest.raises(ValueError, match="max_bytes is 0"):
        homolog.describe(path, max_bytes=0)
    with pytest.raises(ValueError, match="in memory already"):
        homolog.describe(bear_arrays(), label=1)
    with pytest.raises(ValueError, match="its label already"):
        homolog.match(one, two, data_label=1)


def test_quads_of_pyvista_are_divided():
    mesh = pyvista.Box()
    assert mesh.regular_faces.shape == (6, 4)
    assert len(homolog.describe(mesh, resolution=32).faces) == 12


def test_vertices_and_triangles(points):
    vertices, faces = bear_arrays()
    assert points_of(SimpleNamespace(vertices=vertices, triangles=faces)) == points


def test_open3d(points):  # of no extra, for it brings half a gigabyte and a web server: pip install open3d-cpu
    open3d = pytest.importorskip("open3d", exc_type=ImportError)  # some systems lack a library of it, such as libusb
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
    with pytest.raises(IndexError, match="no match 99"):
        viz.plotter(family, 99)
