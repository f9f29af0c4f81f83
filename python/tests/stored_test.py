# SPDX-License-Identifier: MIT
"""Families in folders: written as the program writes them, and read again."""
import filecmp
import json
import pickle
import shutil
import subprocess
from dataclasses import replace

import homolog
import numpy as np
import pytest
from shapes import COARSE, bear_arrays, bytes_of, moved, program_path

FLAGS = ["--resolution", "64", "--sigma0", "0.8", "--quiet"]  # COARSE
FILES = ["match.json", "parts.json", "report.html", "model.part.ply", "data.part.ply", "model.landmarks.csv", "data.landmarks.csv",
         "model.mrk.json", "data.mrk.json"]  # fmt: skip
UPPER = ((0, 0.5, 0), (1, 1, 1))


def off(path, vertices, faces):
    rows = [" ".join(map(repr, map(float, v))) for v in vertices] + [f"3 {a} {b} {c}" for a, b, c in faces]
    path.write_text("\n".join(["OFF", f"{len(vertices)} {len(faces)} 0", *rows]))


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("stored")
    vertices, faces = bear_arrays()
    off(folder / "bear.off", vertices, faces)
    off(folder / "moved.off", moved(vertices), faces)
    family = homolog.match(folder / "bear.off", folder / "moved.off", **COARSE)
    family.save(folder / "bears")
    with (folder / "family.pickle").open("wb") as file:
        pickle.dump(family, file)
    return folder


@pytest.fixture(scope="module")
def family(folder):
    return pickle.loads((folder / "family.pickle").read_bytes())


@pytest.fixture(scope="module")
def loaded(folder):
    return homolog.load(folder / "bears" / "match.json")


@pytest.fixture(scope="module")
def program():
    return program_path()


def assert_same(one, other, names):
    assert sorted(path.name for path in one.iterdir()) == sorted(path.name for path in other.iterdir()) == sorted(names)
    assert filecmp.cmpfiles(one, other, names, shallow=False)[0] == names


def test_a_saved_family_is_the_folder_of_the_program(folder, program):
    subprocess.run([program, "match", "bear.off", "moved.off", *FLAGS, "--out", "by_program"], cwd=folder, check=True, capture_output=True)
    assert_same(folder / "bears", folder / "by_program", FILES)


def test_so_are_saved_symmetries(folder, program):
    vertices, faces = bear_arrays(arm=(1.9, 0.9, 0.4))
    off(folder / "even.off", vertices, faces)
    symmetries = homolog.symmetry(folder / "even.off", **COARSE)
    symmetries.save(folder / "self")
    subprocess.run([program, "symmetry", "even.off", *FLAGS, "--out", "self_by_program"], cwd=folder, check=True, capture_output=True)
    assert_same(folder / "self", folder / "self_by_program", [*FILES, "symmetry.json"])
    again = homolog.load(folder / "self")
    assert [bytes_of(s.normal) for s in again.symmetries] == [bytes_of(s.normal) for s in symmetries.symmetries]
    assert again.symmetries[0].sentence == symmetries.symmetries[0].sentence


def test_what_was_pickled_or_loaded_is_saved_as_the_same_files(folder, family, loaded):
    family.save(folder / "pickled")
    assert_same(folder / "bears", folder / "pickled", FILES)
    loaded.save(folder / "loaded")
    assert (folder / "bears/match.json").read_bytes() == (folder / "loaded/match.json").read_bytes()
    assert (folder / "bears/parts.json").read_bytes() == (folder / "loaded/parts.json").read_bytes()


def test_a_loaded_family_is_the_one_that_was_found(family, loaded):
    assert repr(loaded) == repr(family) and loaded.counts == family.counts and loaded.doubt == family.doubt
    assert loaded.model.name == "bear.off" and loaded.model.diagonal == family.model.diagonal
    np.testing.assert_array_equal(loaded.model.points.position, family.model.points.position)
    for mine, its in zip(loaded, family):
        for name in ("pairs", "pair_confidence", "model_points", "data_points", "similarity"):
            np.testing.assert_array_equal(getattr(mine, name), getattr(its, name))
        assert bytes_of(mine.data_from_model) == bytes_of(its.data_from_model)
        np.testing.assert_allclose(mine.model_part, its.model_part, atol=5.1e-4)  # the file has three digits


def test_a_loaded_family_carries_as_a_fresh_one(folder, family, loaded):
    points = np.vstack([family.model.vertices[::50], np.full(3, np.nan), [99, 99, 99]])
    mine, its = loaded[0].carry_to_data(points), family[0].carry_to_data(points)
    for name in ("position", "there", "expected_error"):
        np.testing.assert_array_equal(getattr(mine, name), getattr(its, name))
    np.testing.assert_allclose(mine.coverage, its.coverage, atol=1e-3)
    assert not mine.there[-2:].any() and np.isnan(mine.position[-2]).all()
    assert bytes_of(loaded.dense().data_from_model) == bytes_of(family.dense().data_from_model)
    (folder / "painted.ply").write_bytes((folder / "bears/model.part.ply").read_bytes())
    assert loaded.transfer(folder / "painted.ply", folder / "worn.ply") == family.transfer(folder / "painted.ply", folder / "worn2.ply")
    assert (folder / "worn.ply").read_bytes() == (folder / "worn2.ply").read_bytes()


def test_its_shapes_can_be_matched_again(family, loaded):
    again = homolog.match(loaded.model, loaded.data)
    assert bytes_of(again[0]) == bytes_of(family[0])


def test_landmarks_go_as_by_the_program(folder, family, program):
    homolog.write_landmarks(folder / "l.csv", [family.model.vertices[0], [9, 9, 9], [np.nan] * 3], ["a", "b,c", "d"])
    landmarks = homolog.read_landmarks(folder / "l.csv")
    for ending in ("csv", "mrk.json", "tps", "pts", "txt"):
        homolog.write_landmarks(folder / f"mine.{ending}", homolog.load(folder / "bears")[0].carry_to_data(landmarks), landmarks.labels, name="moved")
        command = [program, "transfer", "bears/match.json", "--points", "l.csv", "--out", f"its.{ending}", "--quiet"]
        subprocess.run(command, cwd=folder, check=True, capture_output=True)
        mine, its = (folder / f"mine.{ending}").read_text(), (folder / f"its.{ending}").read_text()
        assert mine == its


def test_without_its_meshes_it_carries_points_alone(folder, family):
    alone = folder / "alone"
    alone.mkdir()
    shutil.copy(folder / "bears/match.json", alone)
    with pytest.warns(UserWarning, match="no parts.json lies beside"):
        loaded = homolog.load(alone)
    point = family.model.vertices[0]
    np.testing.assert_array_equal(loaded[0].carry_to_data(point).position, family[0].carry_to_data(point).position)
    for what in (loaded.dense, loaded.morph, lambda: homolog.match(loaded.model, loaded.data), lambda: loaded.save(folder / "no")):
        with pytest.raises(ValueError, match="the mesh of 'bear.off' does not lie beside"):
            what()
    with pytest.warns(UserWarning):
        given = homolog.load(alone, model=folder / "bear.off", data=family.data)
    with pytest.raises(ValueError, match="no parts.json lay beside"):
        given.save(folder / "no")
    assert bytes_of(given.dense().data_from_model.position.shape) == bytes_of(family.dense().data_from_model.position.shape)


def test_what_does_not_fit_is_told(folder, family):
    with pytest.raises(FileNotFoundError, match="match.json"):
        homolog.load(folder / "nowhere" / "match.json")
    with pytest.raises(ValueError, match="but the model of .* had"):
        homolog.load(folder / "bears", model=(np.eye(3), [[0, 1, 2]]))
    (folder / "other").mkdir()
    (folder / "other/match.json").write_text(json.dumps({"format": "homolog-points", "version": 1}))
    with pytest.raises(OSError, match='its format is "homolog-points"'):
        homolog.load(folder / "other")
    with pytest.raises(ValueError, match="were changed"):
        replace(family, matches=()).save(folder / "changed")
    (folder / "file").write_text("")
    with pytest.raises(OSError, match="cannot make the folder"):
        family.save(folder / "file" / "in")


def test_a_part_that_was_matched_is_not_taken_for_the_whole(folder):
    homolog.match(folder / "bear.off", folder / "moved.off", model_part=UPPER, **COARSE).save(folder / "upper")
    loaded = homolog.load(folder / "upper")
    with pytest.raises(ValueError, match="describe it again with its part"):
        homolog.match(loaded.model, loaded.data)
