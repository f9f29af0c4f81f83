# SPDX-License-Identifier: MIT
"""The whole way from Python; twins of tests/homolog_test.cpp, and what Python adds."""
import pickle
import signal
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import homolog
import numpy as np
import pytest
from shapes import COARSE, bear_arrays, bytes_of, moved

RIGHT = 0.02  # of the data's diagonal, as in the C++ twin


@pytest.fixture(scope="module")
def bear():
    return bear_arrays()


@pytest.fixture(scope="module")
def family(bear):
    vertices, faces = bear
    return homolog.match((vertices, faces), (moved(vertices), faces), **COARSE)


def test_a_bear_finds_itself_moved_turned_and_scaled(bear, family):
    best, truth = family[0], moved(family.model.points.position)
    diagonal = np.linalg.norm(np.ptp(moved(bear[0]), axis=0))
    assert np.linalg.norm(best.data_from_model(family.model.points.position) - truth, axis=1).mean() < RIGHT * diagonal
    assert best.confidence > 0.5


def test_pairs_name_the_points_they_join(family):
    best = family[0]
    assert best.pairs.shape == (len(best.model_points), 2)
    np.testing.assert_array_equal(family.model.points.position[best.pairs[:, 0]], best.model_points)
    positions = np.concatenate([family.data.points.position, family.followed.position])
    np.testing.assert_array_equal(positions[best.pairs[:, 1]], best.data_points)


def test_the_map_is_the_equation_of_its_docstring(family):
    spline, x = family[0].data_from_model, np.array([0.3, -0.2, 0.1])
    phi = np.linalg.norm(x - spline.centres, axis=1) ** {"r": 1, "r3": 3}[spline.kernel]
    np.testing.assert_allclose(spline(x), spline.affine @ [*x, 1] + phi @ spline.weights, rtol=1e-9)
    assert spline(np.zeros((0, 3))).shape == (0, 3)


def test_a_described_shape_is_reused_and_keeps_its_parameters(bear, family):
    vertices, faces = bear
    model = homolog.describe(bear, **COARSE)
    again = homolog.match(model, (moved(vertices), faces))
    assert bytes_of(again) == bytes_of(family)
    with pytest.raises(ValueError, match="described with resolution 64"):
        homolog.match(model, model, resolution=80)


def test_doubt_stands_below_the_table(family):
    assert family.doubt == "" and "likely" not in repr(family) + family._repr_html_()
    doubtful = replace(family, doubt="No match here is likely.")
    assert repr(doubtful) == f"{family!r}\nNo match here is likely."
    assert doubtful._repr_html_() == f"{family._repr_html_()}<p>No match here is likely.</p>"


def test_results_pickle_and_their_shapes_can_be_matched_again(bear, family):
    copy = pickle.loads(pickle.dumps(family))
    np.testing.assert_array_equal(copy[0].carry_to_model(moved(bear[0])).position, family[0].carry_to_model(moved(bear[0])).position)
    assert bytes_of(copy) == bytes_of(homolog.match(copy.model, copy.data)) == bytes_of(family)


def test_points_are_carried_to_the_data_and_back(bear, family):
    best, vertices = family[0], bear[0]
    there = best.carry_to_data(vertices)
    np.testing.assert_allclose(there.position, best.data_from_model(vertices), rtol=1e-9)
    assert there.there.dtype == bool and there.there.mean() > 0.9
    assert there.expected_error.shape == there.coverage.shape == (len(vertices),)
    back = best.carry_to_model(there.position)
    np.testing.assert_allclose(back.position[back.there], vertices[back.there], atol=1e-6)
    assert not best.carry_to_data(vertices[0] + 100).there
    assert best.carry_to_data(vertices[0]).position.shape == (3,)


def test_covered_parts_are_weights_of_the_vertices(bear, family):
    best = family[0]
    for part in (best.model_part, best.data_part):
        assert part.shape == (len(bear[0]),) and part.min() >= 0 and part.max() <= 1
        assert part.mean() > 0.9


def test_results_show_themselves(family):
    assert repr(family).splitlines()[0].split()[:3] == ["rank", "pairs", "confidence"]
    assert family._repr_html_().count("<tr>") == len(family) + 1
    assert family[0]._repr_html_().count("<tr>") == 2


def test_a_part_is_a_box_of_shares(bear):
    upper = homolog.points(homolog.describe(bear, part=((0, 0.5, 0), (1, 1, 1)), **COARSE))
    assert len(upper) > 0
    assert upper.position[:, 1].min() > (bear[0][:, 1].min() + bear[0][:, 1].max()) / 2


def test_the_upper_half_is_found_in_the_whole(bear):
    vertices, faces = bear
    best = homolog.match(bear, (moved(vertices), faces), model_part=((0, 0.5, 0), (1, 1, 1)), **COARSE)[0]
    upper = vertices[:, 1] > (vertices[:, 1].min() + vertices[:, 1].max()) / 2
    bound = RIGHT * np.linalg.norm(np.ptp(moved(vertices), axis=0))
    assert np.linalg.norm(best.data_from_model(vertices) - moved(vertices), axis=1)[upper].mean() < bound
    assert best.model_part[~upper].max() == 0


@pytest.fixture(scope="module")
def symmetric_bear():
    vertices, faces = bear_arrays(arm=(1.9, 0.9, 0.4))
    return vertices, homolog.symmetry((vertices, faces), **COARSE)


def test_a_bears_symmetry_is_its_mirror_image_and_not_the_identity(symmetric_bear):
    vertices, found = symmetric_bear
    bound = RIGHT * np.linalg.norm(np.ptp(vertices, axis=0))
    assert np.linalg.norm(found[0].data_from_model(vertices) - vertices * [-1, 1, 1], axis=1).mean() < bound
    for match in found:
        assert np.linalg.norm(match.data_from_model(vertices) - vertices, axis=1).mean() > bound


def test_the_mirror_plane_of_a_bear_is_exact(symmetric_bear):
    vertices, found = symmetric_bear
    symmetry = found.symmetries[0]
    assert len(found.symmetries) == len(found)
    np.testing.assert_allclose(symmetry.normal, [1, 0, 0], atol=0.01)
    assert abs(symmetry.offset) < 0.01
    reflected = vertices @ symmetry.matrix[:3, :3].T + symmetry.matrix[:3, 3]
    np.testing.assert_allclose(reflected, vertices - 2 * np.outer(vertices @ symmetry.normal - symmetry.offset, symmetry.normal), atol=1e-12)
    assert symmetry.error < 0.003


def test_a_bent_body_is_less_exact_than_a_straight_one(symmetric_bear, bear):
    bent = [symmetry for symmetry in homolog.symmetry(bear, mirror="only", **COARSE).symmetries if symmetry.normal is not None]
    assert bent[0].error > 5 * symmetric_bear[1].symmetries[0].error
    assert bent[0].error > 0.01


def test_symmetries_say_themselves_and_pickle(symmetric_bear, family):
    found = symmetric_bear[1]
    sentence = found.symmetries[0].sentence
    assert sentence.startswith("mirrored in the plane 1.0000 x") and sentence in repr(found) and sentence in found._repr_html_()
    assert bytes_of(pickle.loads(pickle.dumps(found))) == bytes_of(found)
    assert family.symmetries == () and "<ol>" not in family._repr_html_()


def test_bytes_repeat_for_any_number_of_threads(bear, family):
    def run(threads):
        return bytes_of(homolog.match(bear, (moved(bear[0]), bear[1]), threads=threads, **COARSE))

    with ThreadPoolExecutor(2) as pool:
        for found in pool.map(run, (1, 3)):
            assert found == bytes_of(family)


def test_every_parameter_is_a_keyword_and_has_its_default(bear):
    defaults = {row["name"]: row["default"] for row in homolog.parameters()}
    shape = homolog.describe(bear, **{**defaults, **COARSE})
    assert bytes_of(shape.points) == bytes_of(homolog.points(bear, **COARSE))


def test_ctrl_c_reaches_python_while_the_library_works(bear):
    heard = []

    def stop_at_third(*_):
        heard.append(True)
        if len(heard) == 3:  # signals that nobody looks for become one
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, stop_at_third)
    signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
    try:
        with pytest.raises(KeyboardInterrupt):
            homolog.describe(bear, resolution=320)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def test_other_threads_run_while_the_library_works(bear):
    with ThreadPoolExecutor(1) as pool:
        working, beats = pool.submit(homolog.describe, bear, resolution=192), 0
        while not working.done():
            time.sleep(0.001)
            beats += 1
    assert beats > 50


@pytest.mark.parametrize("wrong, word", [
    ({"resolutoin": 64}, "did you mean 'resolution'"), ({"shellcount": 4}, "did you mean 'shell_count'"),
    ({"colour": 1}, "homolog.parameters"), ({"resolution": 31}, "resolution"), ({"resolution": 64.5}, "resolution"),
    ({"bending": float("nan")}, "bending"), ({"mirror": "maybe"}, "mirror"), ({"preset": "best"}, "preset"), ({"threads": -1}, "threads"),
    ({"part": ((1, 1, 1), (0, 0, 0))}, "part"), ({"part": "upper"}, "upper"), ({"part": ((0, 0, 0), (1, 1, np.nan))}, "part"),
])  # fmt: skip
def test_wrong_parameters_are_refused(bear, wrong, word):
    with pytest.raises(ValueError, match=word):
        homolog.describe(bear, **wrong)


@pytest.mark.parametrize("shape, word", [
    (None, "no shape"), ((np.zeros((4, 2)), np.zeros((1, 3), int)), "vertices"), ((np.zeros((4, 3)), np.zeros((1, 4), int)), "divide"),
    ((np.zeros((4, 3)), np.zeros((1, 3))), "faces"), ((np.zeros((4, 3)), [[0, 1, -1]]), "-1"), ((np.eye(3), [[0, 1, 7]]), "vertex 7"),
    ((np.eye(3), [[0, 1, 2], [0, 1, 10**7]]), "vertex 10000000"),
    ((np.full((3, 3), np.nan), [[0, 1, 2]]), "finite"), ((np.eye(3), [[0, 1, 2]]), "volume|solid|extent|inside"), ((np.eye(3), np.zeros((0, 3), int)), "triangles"),
])  # fmt: skip
def test_unusable_shapes_are_refused(shape, word):
    with pytest.raises(ValueError, match=word):
        homolog.describe(shape, **COARSE)


def test_unreadable_files_are_told(tmp_path):
    with pytest.raises(FileNotFoundError, match="nowhere.off"):
        homolog.points(tmp_path / "nowhere.off")
    (tmp_path / "garbage.off").write_text("no mesh")
    with pytest.raises(OSError, match="garbage.off"):
        homolog.points(str(tmp_path / "garbage.off"))


def test_what_of_a_file_is_left_out_is_told(tmp_path, bear):
    vertices, faces = bear
    lines = ["v {} {} {}".format(*x) for x in vertices] + ["f {} {} {}".format(*(t + 1)) for t in faces]
    (tmp_path / "a.obj").write_text("\n".join([*lines, "cstype bezier", "deg 1 1", "surf 0 1 0 1 1 2 3 4", "end", ""]))
    for read in (homolog.describe, homolog.points):
        with pytest.warns(UserWarning, match=r"a\.obj: 1 free-form surface \(surf\) is left out; make polygons") as told:
            read(tmp_path / "a.obj", **COARSE)
        assert [warning.filename for warning in told] == [__file__]
