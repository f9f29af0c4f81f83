# SPDX-License-Identifier: MIT
# homolog transfer as a user meets it.
import csv
import json
import os

import bear
from program import COARSE, Program, main


class Transfer(Program):
    """Landmarks and a mesh carried by a match of the upper half of one bear with the other, which is 2.5 times as large."""

    HEAD, NECK, FOOT = (0, 2.1, 0.1), (0.3, 1.2, 0.4), (0.75, -2, 0.9)

    def setUp(self):
        super().setUp()
        done = self.run_it("match", "bear.off", "bear_bis.off", "--model-part", "y>0.5", "--mirror", "forbid", "--out", "out", *COARSE)
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [(f"p{i}", *x) for i, x in enumerate((self.HEAD, self.NECK, self.FOOT))] + [("gone", "", "", "")]
        with open(self.path("points.csv"), "w") as file:
            csv.writer(file).writerows([("label", "x", "y", "z"), *rows])

    def carried(self, name):
        return {row["label"]: row for row in csv.DictReader(self.read(name).splitlines())}

    def distance(self, row, place):
        return sum((float(row[axis]) - c) ** 2 for axis, c in zip("xyz", place)) ** 0.5

    def test_points(self):
        done = self.run_it("transfer", "out/match.json", "--points", "points.csv", "--out", "carried.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, "2 of 4 points carried from bear.off to bear_bis.off; 2 outside the covered part\n")
        rows = self.carried("carried.csv")
        self.assertEqual(list(rows), ["p0", "p1", "p2", "gone"])
        for label, place in (("p0", self.HEAD), ("p1", self.NECK)):
            self.assertLess(self.distance(rows[label], bear.turned(place)), 0.5)  # a twentieth of the height
            self.assertGreater(float(rows[label]["expected_error"]), 0)
        for label in ("p2", "gone"):
            self.assertEqual([rows[label][column] for column in ("x", "y", "z", "expected_error")], ["", "", "", ""])
        self.assertLess(float(rows["p2"]["coverage"]), 0.5)

        done = self.run_it("transfer", "out/match.json", "--points", "carried.csv", "--inverse", "--out", "back.mrk.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        points = json.loads(self.read("back.mrk.json"))["markups"][0]["controlPoints"]
        self.assertEqual([p["positionStatus"] for p in points], ["defined", "defined", "undefined", "undefined"])
        self.assertLess(max(abs(a - b) for a, b in zip(points[0]["position"], self.HEAD)), 1e-6)
        self.assertNotIn("position", points[2])

    def test_formats_of_morphometrics(self):
        with open(self.path("points.fcsv"), "w") as file:
            file.write("# Markups fiducial file version = 4.13\n# CoordinateSystem = 0\n")
            file.write("# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n")
            for i, (x, y, z) in enumerate((self.HEAD, self.FOOT)):
                file.write(f"{i},{-x},{-y},{z},0,0,0,1,1,1,0,p{i},,\n")
        for name in ("carried.tps", "carried.pts", "carried.txt"):
            done = self.run_it("transfer", "out/match.json", "--points", "points.fcsv", "--out", name)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            missing = "p1 9999 9999 9999" if name.endswith(".pts") else "NA NA NA"
            lines = self.read(name).splitlines()
            self.assertIn(missing, lines)
            head = lines[lines.index(missing) - 1].split()[-3:]
            self.assertLess(self.distance(dict(zip("xyz", head)), bear.turned(self.HEAD)), 0.5)
            done = self.run_it("transfer", "out/match.json", "--points", name, "--inverse", "--out", "back.csv")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            back = list(self.carried("back.csv").values())
            self.assertLess(self.distance(back[0], self.HEAD), 1e-6)
            self.assertEqual(back[1]["x"], "")
        self.assertIn("ID=bear_bis\n", self.read("carried.tps"))

    def test_one_specimen_of_several(self):
        with open(self.path("all.tps"), "w") as file:
            file.write("".join("LM3=1\n{} {} {}\nID=b{}\n".format(*x, i) for i, x in enumerate((self.FOOT, self.HEAD))))
        transfer = ("transfer", "out/match.json", "--points", "all.tps", "--out", "a.csv")
        self.expect_message(3, "it holds 2 specimens; choose one by its name or number with --specimen: 1 b0, 2 b1", *transfer)
        self.expect_message(3, "it holds no specimen 'b7'", *transfer, "--specimen", "b7")
        self.expect_message(3, "leave --specimen out", "transfer", "out/match.json", "--points", "points.csv", "--out", "a.csv", "--specimen", "1")
        self.expect_message(2, "--specimen goes with --points", "transfer", "out/match.json", "--mesh", "bear.off", "--out", "a.ply", "--specimen", "1")
        done = self.run_it(*transfer, "--specimen", "b1")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertLess(self.distance(self.carried("a.csv")["1"], bear.turned(self.HEAD)), 0.5)

    def test_mesh(self):
        done = self.run_it("transfer", "out/match.json", "--mesh", "bear.off", "--out", "bent.ply")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        vertices = [line.split() for line in self.read("bent.ply").split("end_header\n")[1].splitlines()]
        top = max((v for v in vertices if len(v) == 5), key=lambda v: float(v[3]))
        self.assertGreater(float(top[3]), 0.9)
        self.assertEqual(self.run_it("points", "bent.ply", *COARSE).returncode, 0)

    def test_wrong_usage_and_files(self):
        match, points = "out/match.json", ("--points", "points.csv")
        self.expect_message(2, "--out is required", "transfer", match, *points)
        self.expect_message(2, "either --points or --mesh", "transfer", match, "--out", "a.csv")
        self.expect_message(2, ".csv, .mrk.json, .tps, .pts or .txt", "transfer", match, *points, "--out", "a.ply")
        self.expect_message(2, "written as .ply", "transfer", match, "--mesh", "bear.off", "--out", "a.obj")
        self.expect_message(2, "--match is 99", "transfer", match, *points, "--match", "99", "--out", "a.csv")
        self.expect_message(3, "out: this is a directory", "transfer", "out", *points, "--out", "a.csv")
        self.expect_message(3, "bear.off: this is not a file of matches", "transfer", "bear.off", *points, "--out", "a.csv")
        self.expect_message(3, "points are read from", "transfer", match, "--points", "bear.off", "--out", "a.csv")
        self.expect_message(4, "cannot write 'none/a.csv'", "transfer", match, *points, "--out", "none/a.csv")
        self.assertFalse(os.path.exists(self.path("a.csv")))

    def test_points_of_another_shape_are_told(self):
        with open(self.path("far.csv"), "w") as file:
            file.write("label,x,y,z\na,900,0,0\n")
        done = self.run_it("transfer", "out/match.json", "--points", "far.csv", "--out", "a.csv")
        self.assertEqual(done.returncode, 1)
        self.assertIn("are the points those of bear.off?", done.stderr)
        os.remove(self.path("out", "parts.json"))
        done = self.run_it("transfer", "out/match.json", "--points", "points.csv", "--out", "a.csv")
        self.assertEqual(done.returncode, 0)
        self.assertIn("warning: no parts.json", done.stderr)


if __name__ == "__main__":
    main()
