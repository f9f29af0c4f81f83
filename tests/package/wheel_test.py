# SPDX-License-Identifier: MIT
# A wheel as a user meets it: installed with pip into a bare environment, it matches in Python and by its command. In: the wheel's folder.
import os
import subprocess
import sys
import tempfile
import unittest
import venv
from pathlib import Path

(WHEEL,) = Path(sys.argv[1]).resolve().glob("homolog-*.whl")
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "cli"))
import bear  # noqa: E402

CODE = """
import homolog
family = homolog.match("bear.off", "bear_bis.off", resolution=64, sigma0=0.8)
family.save("by_python")
print(family[0].confidence, homolog.__version__)
"""


def run(folder, *words):
    environment = {name: os.environ[name] for name in ("PATH", "HOME") if name in os.environ}
    return subprocess.run(words, cwd=folder, check=True, capture_output=True, text=True, env=environment).stdout


class Wheel(unittest.TestCase):
    def test_it_works_where_nothing_else_is(self):
        with tempfile.TemporaryDirectory() as scratch:
            folder = Path(scratch)
            venv.create(folder / "bare", with_pip=True)
            bear.write_all(scratch)
            run(folder, "bare/bin/pip", "-q", "--disable-pip-version-check", "install", str(WHEEL))
            confidence, version = run(folder, "bare/bin/python", "-c", CODE).split()
            self.assertGreater(float(confidence), 0.5)
            self.assertEqual(run(folder, "bare/bin/homolog", "--version").split()[-1], version)
            coarse = ("--resolution", "64", "--sigma0", "0.8")
            run(folder, "bare/bin/homolog", "match", "bear.off", "bear_bis.off", *coarse, "--out", "by_program")
            for name in ("match.json", "parts.json", "report.html"):
                self.assertEqual((folder / "by_python" / name).read_bytes(), (folder / "by_program" / name).read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:])
