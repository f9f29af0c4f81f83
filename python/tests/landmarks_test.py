# SPDX-License-Identifier: MIT
"""Landmark files; twins of the tests of tests/outputs that read and write them, and the way of tests/cli/transfer_test.py."""
import homolog
import numpy as np
import pytest

NAN = np.full(3, np.nan)
POINTS = np.array([[0.1, -2, 3e-20], NAN, [4, 5, 6]])
LABELS = ["left ear", "tail", "nose"]
ENDINGS = ["csv", "mrk.json", "tps", "pts", "txt"]


@pytest.mark.parametrize("ending", ENDINGS)
def test_what_is_written_is_read_back(tmp_path, ending):
    path = tmp_path / f"bear.{ending}"
    homolog.write_landmarks(path, POINTS, LABELS)
    again = homolog.read_landmarks(str(path))
    np.testing.assert_array_equal(again.position, POINTS)
    assert again.labels == tuple(name.replace(" ", "_") if ending == "pts" else name for name in LABELS)
    assert len(again) == 3 and again.there.tolist() == [True, False, True]
    assert repr(again) == "<homolog.Landmarks: 3, 1 of them missing>"
    assert again._repr_html_().count("<tr>") == 4 and "<td>tail</td><td></td>" in again._repr_html_()
    homolog.write_landmarks(tmp_path / f"again.{ending}", again, name="bear")
    assert (tmp_path / f"again.{ending}").read_bytes() == path.read_bytes()


def test_3d_slicers_files_go_by_their_own_coordinate_system(tmp_path):
    fcsv = "# Markups fiducial file version = 5.0\n# CoordinateSystem = {}\n# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label\n"
    row = "1,1,2,3,0,0,0,1,1,1,0,nose\n"
    for system, sign in (("LPS", 1), ("RAS", -1), ("0", -1), ("1", 1)):
        (tmp_path / "a.fcsv").write_text(fcsv.format(system) + row)
        np.testing.assert_array_equal(homolog.read_landmarks(tmp_path / "a.fcsv").position, [[sign, 2 * sign, 3]])
        np.testing.assert_array_equal(homolog.read_landmarks(tmp_path / "a.fcsv", ras=True).position, [[-sign, -2 * sign, 3]])
    homolog.write_landmarks(tmp_path / "a.mrk.json", [[1, 2, 3]], ["nose"], ras=True)
    assert '"coordinateSystem": "RAS"' in (tmp_path / "a.mrk.json").read_text()
    np.testing.assert_array_equal(homolog.read_landmarks(tmp_path / "a.mrk.json").position, [[-1, -2, 3]])


def test_one_specimen_of_several(tmp_path):
    (tmp_path / "a.tps").write_text("LM3=1\n1 2 3\nID=anna\nLM3=1\n4 5 6\nID=otto\n")
    np.testing.assert_array_equal(homolog.read_landmarks(tmp_path / "a.tps", specimen="otto").position, [[4, 5, 6]])
    np.testing.assert_array_equal(homolog.read_landmarks(tmp_path / "a.tps", specimen=1).position, [[1, 2, 3]])
    with pytest.raises(OSError, match="it holds 2 specimens; .*: 1 anna, 2 otto"):
        homolog.read_landmarks(tmp_path / "a.tps")


def test_what_is_wrong_is_told(tmp_path):
    with pytest.raises(FileNotFoundError, match="nowhere.csv"):
        homolog.read_landmarks(tmp_path / "nowhere.csv")
    (tmp_path / "a.csv").write_text("x,y,z\n1,2\n")
    with pytest.raises(OSError, match="a.csv, line 2: 2 cells, but the header has 3"):
        homolog.read_landmarks(tmp_path / "a.csv")
    with pytest.raises(ValueError, match="points are written as .csv"):
        homolog.write_landmarks(tmp_path / "a.fcsv", POINTS, LABELS)
    with pytest.raises(ValueError, match="there are 1 labels, but 3 points"):
        homolog.write_landmarks(tmp_path / "b.csv", POINTS, ["nose"])
    with pytest.raises(ValueError, match=r"the shape \(3,\), but must have \(n, 3\)"):
        homolog.write_landmarks(tmp_path / "b.csv", POINTS[0])
    with pytest.raises(OSError, match="cannot write"):
        homolog.write_landmarks(tmp_path / "none" / "b.csv", POINTS, LABELS)
    assert not (tmp_path / "b.csv").exists()
