# SPDX-License-Identifier: MIT
"""The examples of the README run as they stand there, on the bears of the program's tests."""
import os
import re
import subprocess
from pathlib import Path

import pyvista
from shapes import bear, bear_arrays, mesh_files, program_path

README = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")


def code_of(start, kind=""):
    """The block that begins with these words."""
    (code,) = re.findall(rf"^```{kind}\n({re.escape(start)}.*?)^```", README, re.S | re.M)
    return code


def test_the_python_example_runs(tmp_path, monkeypatch):
    bear.write_all(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    names = {}
    exec(code_of("import homolog", "python"), names)
    assert len(names["heights"]) == len(names["family"].data.vertices) and (tmp_path / "morph.glb").read_bytes()[:4] == b"glTF"
    assert len(names["family"]) > 0 and names["carried"].position.shape == names["model"].vertices.shape
    assert (tmp_path / "bears/report.html").exists()


def test_the_commands_run(tmp_path):
    bear.write_all(tmp_path)
    vertices, faces = (rows.tolist() for rows in bear_arrays())
    (tmp_path / "landmarks.csv").write_text("label,x,y,z\nnose,0,1.3,0.98\n")
    rows = [f"v {x} {y} {z}\nvt {x} {y}" for x, y, z in vertices] + ["f " + " ".join(f"{i + 1}/{i + 1}" for i in face) for face in faces]
    (tmp_path / "painted.obj").write_text("\n".join(rows))
    (tmp_path / "rigged.glb").write_bytes(mesh_files.rigged_glb(vertices, faces, neck=0.9))
    path = f"{program_path().parent}:{os.environ['PATH']}"
    done = subprocess.run(["bash", "-eu", "-c", code_of("homolog match")], cwd=tmp_path, env={**os.environ, "PATH": path}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    for name in ("bears/report.html", "bears/dense/dense.json", "morph.glb", "self/symmetry.json", "carried.csv", "worn.obj", "worn.glb", "points/points.csv"):
        assert (tmp_path / name).exists(), name
