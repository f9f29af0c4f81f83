# SPDX-License-Identifier: MIT
"""Every vertex on the other mesh; twins of tests/match/dense_test.cpp, carry_attributes_test.cpp, outputs/morph_test.cpp."""
import pickle
from dataclasses import replace

import homolog
import numpy as np
import pytest
from shapes import COARSE, ROTATION, SCALE, bear_arrays, bytes_of, mesh_files, moved

WITHIN = 0.05  # of the data's diagonal


@pytest.fixture(scope="module")
def family():
    vertices, faces = bear_arrays()
    return homolog.match((vertices, faces), (moved(vertices), faces[::-1]), **COARSE)


@pytest.fixture(scope="module")
def dense(family):
    return family.dense()


def diagonal(vertices):
    return np.linalg.norm(np.ptp(vertices, axis=0))


def test_every_vertex_finds_its_own_place(family, dense):
    for places, truth in ((dense.data_from_model, family.data), (dense.model_from_data, family.model)):
        there = places.there
        assert there.mean() > 0.95
        away = np.linalg.norm(places.position - truth.vertices, axis=1)[there] / diagonal(truth.vertices)
        assert away.mean() < WITHIN / 5 and away.max() < WITHIN
        corners = truth.vertices[truth.faces[places.triangle[there]]]
        np.testing.assert_allclose(np.einsum("nk,nkc->nc", places.barycentric[there], corners), places.position[there], atol=1e-9)
        np.testing.assert_allclose(places.barycentric[there].sum(axis=1), 1)
        assert np.isnan(places.position[~there]).all() and (places.confidence[~there] == 0).all()
        assert places.folded <= 0.01 * places.triangles


def test_values_lie_between_and_labels_do_not(family, dense):
    model, data = family.model.vertices, family.data.vertices
    carried = dense.carry_to_data(model)  # places as values of three columns
    there = dense.model_from_data.there
    np.testing.assert_allclose(carried[there], dense.model_from_data.position[there], atol=1e-9)
    assert np.isnan(carried[~there]).all()
    sides = np.where(model[:, 0] > 0, 900, 7)
    labels = dense.carry_to_data(sides, labels=True)
    assert labels.shape == (len(data),) and set(labels[there]) == {7, 900}
    assert (labels == sides)[there].mean() > 0.95
    back = dense.carry_to_model(data[:, 2])
    assert np.nanmax(np.abs(back - moved(model)[:, 2])) < WITHIN * diagonal(data)


def test_a_value_that_is_not_known_stays_so(family, dense):
    assert np.isnan(dense.carry_to_data(np.full(len(family.model.vertices), np.nan))).all()
    with pytest.raises(ValueError, match=r"shape \(3,\), but must be numbers"):
        dense.carry_to_data([1, 2, 3])
    with pytest.raises(ValueError, match="of type <U1"):
        dense.carry_to_data(["a"] * len(family.model.vertices))


def test_a_morph_begins_at_the_model_and_ends_at_the_data(family, tmp_path):
    morph = family.morph()
    assert np.linalg.norm(morph.end - family.data.vertices, axis=1).mean() < WITHIN / 5 * diagonal(family.data.vertices)
    similarity = family[0].similarity
    np.testing.assert_allclose(morph.start, family.model.vertices @ similarity[:3, :3].T + similarity[:3, 3], atol=1e-9)
    np.testing.assert_array_equal(morph.frame(1), morph.end)
    np.testing.assert_allclose(morph.frame(0.5), (morph.start + morph.end) / 2)
    morph.write(tmp_path / "morph.glb", colours=np.full_like(morph.start, 99))
    scene, table = mesh_files.read_glb((tmp_path / "morph.glb").read_bytes())
    primitive = scene["meshes"][0]["primitives"][0]
    end = np.add(table(primitive["attributes"]["POSITION"]), table(primitive["targets"][0]["POSITION"])) + scene["nodes"][0]["translation"]
    np.testing.assert_allclose(end, morph.end, atol=1e-5 * diagonal(morph.end))
    with pytest.raises(ValueError, match="the colours must be"):
        morph.write(tmp_path / "a.glb", colours=[[1, 2, 3]])
    with pytest.raises(ValueError, match="written as .glb"):
        morph.write(tmp_path / "a.obj")
    with pytest.raises(OSError, match="cannot write"):
        morph.write(tmp_path / "none" / "a.glb")


def volume(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.einsum("nk,nk->", a, np.cross(b, c)) / 6


def test_a_mirrored_morph_shows_its_outer_side():
    vertices, faces = bear_arrays()
    mirror = np.diag([-1, 1, 1])
    family = homolog.match((vertices, faces), (moved(vertices) @ mirror, faces[:, ::-1]), **COARSE, mirror="only")
    morph = family.morph()
    assert np.linalg.det(family[0].similarity[:3, :3]) < 0 < volume(vertices, faces)
    for share in (0, 1):
        assert volume(morph.frame(share), morph.faces) == pytest.approx(SCALE**3 * volume(vertices, faces), rel=0.05)
    assert 0 <= morph.folded <= 0.01 * morph.triangles


def test_vertices_that_are_not_there_are_refused(family, tmp_path):
    vertices, faces = bear_arrays()
    far, holed = faces.copy(), family.data.vertices.copy()
    far[5, 1], holed[3] = 10**7, np.nan
    (tmp_path / "rigged.glb").write_bytes(mesh_files.rigged_glb(vertices.tolist(), faces.tolist(), neck=0.9))
    with pytest.raises(ValueError, match="names vertex 10000000, but there are"):
        family.transfer(tmp_path / "rigged.glb", tmp_path / "a.glb", onto=(vertices, far))
    with pytest.raises(ValueError, match="a coordinate of vertex 3 is not a finite number"):
        family.transfer(tmp_path / "rigged.glb", tmp_path / "a.glb", onto=(holed, faces))
    family.save(tmp_path / "saved")
    with pytest.raises(ValueError, match="names vertex 10000000"):
        homolog.load(tmp_path / "saved", model=(vertices, far)).dense()
    morph = family.morph()
    for wrong, word in ((replace(morph, faces=far), "names vertex 10000000"), (replace(morph, end=morph.end[:7]), "but they must have one")):
        with pytest.raises(ValueError, match=word):
            wrong.write(tmp_path / "a.glb")
    assert not (tmp_path / "a.glb").exists()


def test_what_was_read_is_not_overwritten(family, tmp_path):
    vertices, faces = bear_arrays()
    (tmp_path / "rigged.glb").write_bytes(mesh_files.rigged_glb(vertices.tolist(), faces.tolist(), neck=0.9))
    (tmp_path / "onto.glb").write_bytes(mesh_files.rigged_glb(family.data.vertices.tolist(), faces.tolist(), neck=0.9))
    for name in ("rigged.glb", "onto.glb"):
        with pytest.raises(OSError, match=f"cannot write '.*{name}': it was read to make this"):
            family.transfer(tmp_path / "rigged.glb", tmp_path / name, onto=tmp_path / "onto.glb")


def test_a_rigged_file_is_carried(family, tmp_path):
    vertices, faces = bear_arrays()
    (tmp_path / "rigged.glb").write_bytes(mesh_files.rigged_glb(vertices.tolist(), faces.tolist(), neck=0.9))
    assert family.transfer(tmp_path / "rigged.glb", tmp_path / "worn.glb") > 0.95 * len(vertices)
    with pytest.warns(UserWarning, match="animations are written to a .glb"):
        family.transfer(tmp_path / "rigged.glb", tmp_path / "worn.ply")
    scene, table = mesh_files.read_glb((tmp_path / "worn.glb").read_bytes())
    primitive = scene["meshes"][0]["primitives"][0]
    np.testing.assert_allclose(np.sum(table(primitive["attributes"]["WEIGHTS_0"]), axis=1), 1, atol=1e-6)
    lifted = np.array(table(primitive["targets"][0]["POSITION"]))
    top = np.argmax(vertices[:, 1])
    np.testing.assert_allclose(lifted[top], SCALE * ROTATION @ [0, 0.5, 0], atol=0.15 * 0.5 * SCALE)
    start, end = np.array(table(scene["animations"][0]["samplers"][0]["output"]))
    np.testing.assert_allclose(end - start, SCALE * ROTATION @ [0, 1, 0], atol=0.15 * SCALE)
    head = np.linalg.inv(np.array(table(scene["skins"][0]["inverseBindMatrices"])[1]).reshape(4, 4).T)
    assert np.linalg.norm(head[:3, 3] - moved(np.array([[0, 0.9, 0]]))) < WITHIN * diagonal(family.data.vertices)


def test_what_lies_elsewhere_raises(family, tmp_path):
    vertices, faces = bear_arrays()
    (tmp_path / "mm.glb").write_bytes(mesh_files.rigged_glb((1000 * vertices).tolist(), faces.tolist(), neck=0.9))
    with pytest.raises(OSError, match="would if scaled by 0.001; save it with the axes and in the unit"):
        family.transfer(tmp_path / "mm.glb", tmp_path / "a.glb")


def test_what_cannot_be_carried_raises(family, tmp_path):
    (tmp_path / "bad.glb").write_bytes(b"glTF")
    with pytest.raises(OSError, match="bad.glb"):
        family.transfer(tmp_path / "bad.glb", tmp_path / "a.glb")
    with pytest.raises(ValueError, match="not as 'a.stl'"):
        family.transfer(tmp_path / "bad.glb", "a.stl")


def test_a_match_that_is_not_there_is_told(family, tmp_path):
    for what in (family.__getitem__, family.dense, family.morph, lambda rank: family.transfer("a.ply", tmp_path / "b.ply", rank)):
        with pytest.raises(IndexError, match=f"there is no match 99: the family has {len(family)}, and the best one is 0"):
            what(99)
    with pytest.raises(IndexError, match="there is no match 0: the family is empty, for nothing was found"):
        replace(family, matches=())[0]


def test_results_pickle_and_show_themselves(family, dense):
    morph = family.morph()
    assert bytes_of(pickle.loads(pickle.dumps((dense.data_from_model, morph)))) == bytes_of((dense.data_from_model, morph))
    assert bytes_of(pickle.loads(pickle.dumps(dense)).model_from_data) == bytes_of(dense.model_from_data)
    assert repr(morph) == f"<homolog.Morph: {len(morph.start)} vertices, {morph.folded} of {morph.triangles} triangles folded over>"
    assert "vertices have a place" in repr(dense)


def test_notebooks_show_counts_and_means(family, dense):
    shown = {type(value).__name__: value._repr_html_() for value in (dense, dense.data_from_model, family.morph(), family.model, family.model.points)}
    count = len(family.model.vertices)
    for name, text in shown.items():
        assert text.startswith("<table>") and f"<td>{len(family.model.points) if name == 'Points' else count}</td>" in text, name
    assert f"<td>{dense.data_from_model.confidence[dense.data_from_model.there].mean():.4g}</td>" in shown["DenseMap"]
    assert shown["Dense"].count("<tr>") == 3
    carried = family[0].carry_to_data([family.model.vertices[0], [99, 99, 99]])
    assert f"<td>2</td><td>1</td><td>{carried.expected_error[0]:.4g}</td>" in carried._repr_html_()
    nothing = family[0].carry_to_data(np.empty((0, 3)))
    assert "<td>0</td><td>0</td><td>-</td>" in nothing._repr_html_()
    shape = homolog.describe((family.model.vertices, family.model.faces), **COARSE)
    shape.name = "<b>&.off"
    assert "<td>&lt;b&gt;&amp;.off</td>" in shape._repr_html_()
