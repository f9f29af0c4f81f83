# SPDX-License-Identifier: MIT
"""The Python example of the README runs as it stands there, on the bears of the program's tests."""
import re
from pathlib import Path

import pyvista
from shapes import bear


def test_readme_example_runs(tmp_path, monkeypatch):
    bear.write_all(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(pyvista, "OFF_SCREEN", True)
    readme = (Path(__file__).parents[2] / "README.md").read_text(encoding="utf-8")
    (code,) = re.findall(r"^```python\n(.*?)^```", readme, re.S | re.M)
    names = {}
    exec(code, names)
    assert len(names["heights"]) == len(names["family"].data.vertices) and (tmp_path / "morph.glb").read_bytes()[:4] == b"glTF"
    assert len(names["family"]) > 0 and names["carried"].position.shape == names["model"].vertices.shape
