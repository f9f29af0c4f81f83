# SPDX-License-Identifier: MIT
"""Landmark files between homolog and R, which reads and writes them by formats.R; left out without Rscript (apt install r-base-core)."""
import shutil
import subprocess
from pathlib import Path

import homolog
import numpy as np
import pytest

pytestmark = pytest.mark.skipif(not shutil.which("Rscript"), reason="no Rscript")

POINTS = np.array([[0.1, -2, 3e-20], [np.nan] * 3, [4, 1 / 3, 9998.5]])
LABELS = ["left ear", 'the "tail"', "nose"]
ENDINGS = ["tps", "pts", "txt"]


def run_r(task, folder):
    done = subprocess.run(["Rscript", "--vanilla", Path(__file__).with_name("formats.R"), task, folder], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_r_reads_what_is_written(tmp_path):
    for ending in ENDINGS:
        homolog.write_landmarks(tmp_path / f"bear.{ending}", POINTS, LABELS)
    run_r("read", tmp_path)
    for ending in ENDINGS:
        np.testing.assert_array_equal(np.genfromtxt(tmp_path / f"bear.{ending}.csv", delimiter=","), POINTS)


def test_what_r_writes_is_read(tmp_path):
    (tmp_path / "points.csv").write_text("\n".join(",".join("NA" if np.isnan(x) else repr(float(x)) for x in row) for row in POINTS))
    run_r("write", tmp_path)
    for ending in ENDINGS:
        landmarks = homolog.read_landmarks(tmp_path / f"bear.{ending}")
        np.testing.assert_array_equal(landmarks.position, POINTS)
        assert landmarks.labels == (("S000", "S001", "S002") if ending == "pts" else ("1", "2", "3"))
