# SPDX-License-Identifier: MIT
"""Markups between homolog and 3D Slicer's own code: pip install '.[interop]'. Left out without it."""
import homolog
import numpy as np
import pytest

slicer = pytest.importorskip("slicer_core", exc_type=ImportError)

POINTS = np.array([[0.125, -2, 3], [np.nan] * 3, [400.5, 1 / 3, -6]])  # in LPS
LABELS = ["left ear", "the, tail", "nose"]
TURN = np.array([-1, -1, 1])  # from LPS to RAS, in which Slicer holds points
UNDEFINED, DEFINED = slicer.vtkMRMLMarkupsNode.PositionUndefined, slicer.vtkMRMLMarkupsNode.PositionDefined
SYSTEMS = {"LPS": slicer.vtkMRMLStorageNode.CoordinateSystemLPS, "RAS": slicer.vtkMRMLStorageNode.CoordinateSystemRAS}
STORAGES = {".mrk.json": slicer.vtkMRMLMarkupsJsonStorageNode, ".fcsv": slicer.vtkMRMLMarkupsFiducialStorageNode}


def stored_list(path):
    """A scene with an empty list of points and what reads and writes it."""
    scene = slicer.vtkMRMLScene()
    points = slicer.vtkMRMLMarkupsFiducialNode()
    storage = STORAGES["".join(path.suffixes)]()
    scene.AddNode(points)
    scene.AddNode(storage)
    storage.SetFileName(str(path))
    return scene, points, storage


@pytest.mark.parametrize("ending", STORAGES)
@pytest.mark.parametrize("system", SYSTEMS)
def test_what_slicer_writes_is_read(tmp_path, ending, system):
    path = tmp_path / f"bear{ending}"
    _scene, points, storage = stored_list(path)
    for label, place in zip(LABELS, POINTS):
        number = points.AddControlPoint([float(x) for x in np.nan_to_num(place * TURN)], label)
        if np.isnan(place).any():
            points.UnsetNthControlPointPosition(number)
    storage.SetCoordinateSystem(SYSTEMS[system])
    assert storage.WriteData(points)
    assert system in path.read_text()
    landmarks = homolog.read_landmarks(path)
    assert list(landmarks.labels) == LABELS
    np.testing.assert_allclose(landmarks.position, POINTS, rtol=1e-6)
    np.testing.assert_allclose(homolog.read_landmarks(path, ras=True).position, POINTS * TURN, rtol=1e-6)


@pytest.mark.parametrize("ras", [False, True])
def test_slicer_reads_what_is_written(tmp_path, ras):
    path = tmp_path / "bear.mrk.json"
    homolog.write_landmarks(path, POINTS * TURN if ras else POINTS, LABELS, ras=ras)
    _scene, points, storage = stored_list(path)
    assert storage.ReadData(points)
    assert [points.GetNthControlPointLabel(i) for i in range(points.GetNumberOfControlPoints())] == LABELS
    statuses = [points.GetNthControlPointPositionStatus(i) for i in range(3)]
    assert statuses == [DEFINED, UNDEFINED, DEFINED]
    for i in (0, 2):
        np.testing.assert_allclose(points.GetNthControlPointPosition(i), POINTS[i] * TURN, rtol=1e-12)
