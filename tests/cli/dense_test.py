# SPDX-License-Identifier: MIT
# homolog dense as a user meets it.
import csv
import json
import os

import bear
from program import COARSE, Program, main


class Dense(Program):
    """The upper half of one bear in the other, which is 2.5 times as large."""

    begins_with = ("match", "bear.off", "bear_bis.off", "--model-part", "y>0.5", "--mirror", "forbid", "--out", "out", *COARSE)
    FILES = ["data.dense.ply", "data_from_model.csv", "dense.json", "model.dense.ply", "model_from_data.csv"]

    def rows(self, name):
        return list(csv.DictReader(self.read("dense", name).splitlines()))

    def vertices(self, name):
        lines = self.read(name).splitlines()
        return [tuple(map(float, line.split())) for line in lines[2 : 2 + int(lines[1].split()[0])]]

    def test_places(self):
        done = self.run_it("dense", "out/match.json", "--out", "dense")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\Adata_from_model: \d+ of \d+ vertices of bear.off have a place on bear_bis.off; \d+ of \d+ triangles")
        self.assertEqual(sorted(os.listdir(self.path("dense"))), self.FILES)
        model, data = self.vertices("bear.off"), self.vertices("bear_bis.off")
        rows, back = self.rows("data_from_model.csv"), self.rows("model_from_data.csv")
        self.assertEqual((len(rows), len(back)), (len(model), len(data)))
        far = 0
        for vertex, row in zip(model, rows):
            if row["triangle"] == "":
                self.assertEqual((row["x"], row["confidence"]), ("", "0"))
                continue
            self.assertAlmostEqual(sum(float(row[b]) for b in ("b0", "b1", "b2")), 1)
            error = sum((float(row[axis]) - c) ** 2 for axis, c in zip("xyz", bear.turned(vertex))) ** 0.5
            far += error > 0.75  # a bit more than a twentieth of the height
        there = [vertex[1] for vertex, row in zip(model, rows) if row["triangle"]]
        self.assertGreater(len(there), 0.3 * len(model))
        self.assertLess(far, 0.1 * len(there))
        self.assertLess(sum(y < -1 for y in there), 0.02 * len(there))  # the feet are no part of the upper half

        summary = json.loads(self.read("dense", "dense.json"))
        self.assertEqual(summary["data_from_model"]["placed"], len(there))
        self.assertEqual(summary["model_from_data"]["placed"], sum(row["triangle"] != "" for row in back))
        self.assertEqual(self.run_it("points", "dense/data.dense.ply", *COARSE).returncode, 0)

    def test_meshes_elsewhere(self):
        for name in ("model.part.ply", "data.part.ply"):
            os.remove(self.path("out", name))
        self.expect_message(3, "name the meshes that were matched by --model and --data", "dense", "out/match.json", "--out", "dense")
        done = self.run_it("dense", "out/match.json", "--model", "bear.off", "--data", "bear_bis.off", "--out", "dense")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_wrong_usage_and_files(self):
        match = "out/match.json"
        self.expect_message(2, "--out is required", "dense", match)
        self.expect_message(2, "--match is 99", "dense", match, "--match", "99", "--out", "dense")
        self.expect_message(2, "--threads is 'x'", "dense", match, "--threads", "x", "--out", "dense")
        self.expect_message(3, "name that one", "dense", match, "--model", "plate.off", "--out", "dense")
        self.expect_message(3, "bear.off: this is not a file of matches", "dense", "bear.off", "--out", "dense")
        self.expect_message(4, "cannot make the folder 'bear.off/dense': a file, or a link that leads nowhere, is in its way; choose another folder", "dense", match, "--out", "bear.off/dense")
        os.symlink("nowhere", self.path("link"))
        self.expect_message(4, "'link': a file, or a link that leads nowhere, is in its way; choose another folder", "dense", match, "--out", "link")
        self.assertFalse(os.path.exists(self.path("dense")))


if __name__ == "__main__":
    main()
