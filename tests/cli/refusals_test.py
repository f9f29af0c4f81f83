# SPDX-License-Identifier: MIT
# What the program refuses, and that its sentences hold nothing but words.
import json
import os
import re

import mesh_files
from program import COARSE, Program, main


class Words(Program):
    def test_options_given_twice(self):
        def twice(name, *values):
            return [word for value in values for word in (name, value)]

        points = ("points", "bear.off")
        self.expect_message(2, "--part is given 2 times, but takes one value; give it once", *points, *twice("--part", "y>0.5", "y<0.5"))
        for name in ("--label", "--out", "--preset", "--threads", "--resolution", "--max-bytes"):
            self.expect_message(2, f"{name} is given 3 times", *points, *twice(name, "1", "1", "2"))
        self.expect_message(2, "--match is given 2 times", "dense", "match.json", "--match", "1", "--out", "a", "--match", "2")
        self.expect_message(2, "did you mean '--quiet'", *points, *twice("--threads", "1", "2"), "--quite")
        self.expect_message(3, "a.json", "transfer", "a.json", "--attributes", "a.ply", "--out", "b.ply", *twice("--labels", "a", "b"))
        done = self.run_it(*points, "--quiet", "--quiet", "--json", "--json", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (0, ""), "a flag says the same twice")

    def test_a_value_that_was_forgotten(self):
        self.expect_message(2, "--out needs a value, but --quiet follows", "points", "bear.off", "--out", "--quiet")
        self.expect_message(2, "--out needs a value, but --resolution follows", "points", "bear.off", "--out", "--resolution", "96")
        self.assertFalse(os.path.exists(self.path("--quiet")))

    def test_help_is_of_the_verb(self):
        self.expect_message(2, "SHAPE is required; 'homolog points --help' tells more", "points")

    def test_no_commands_for_the_terminal(self):
        done = self.run_it("points", "none\x1b[31m\nü\x7f\x9b.ply")
        self.assertEqual((done.returncode, done.stderr), (3, "homolog: none?[31m?ü??.ply: there is no such file; check the path\n"))
        head, *lines = self.read("bear.off").splitlines()
        vertices, faces, edges = lines[0].split()
        with open(self.path("a\x1b[31m.off"), "w") as file:  # open, which is told
            file.write("\n".join((head, f"{vertices} {int(faces) - 9} {edges}", *lines[1:-9])) + "\n")
        done = self.run_it("points", "a\x1b[31m.off", *COARSE)
        self.assertIn("homolog: warning: a?[31m.off", done.stderr)
        self.assertNotIn("\x1b", done.stdout + done.stderr)
        self.expect_message(3, "the name of a file is empty; name the file to read", "points", "")


class Omissions(Program):
    def test_what_is_left_out_is_told(self):
        v, f = mesh_files.solid()
        self.write("solid.obj", mesh_files.obj(v, f) + b"cstype bezier\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nend\n")
        self.write("solid.ac", mesh_files.ac3d(v, f).replace(b'name "solid"', b'name "solid"\nhidden'))
        for name, sentence in (("solid.obj", "1 free-form surface (surf) is left out"), ("solid.ac", "1 hidden object is read like the others")):
            done = self.run_it("points", name, *COARSE)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, rf"\Ahomolog: warning: {name}: {re.escape(sentence)}; [^\n]+\n\Z")
            self.assertEqual(self.run_it("points", name, "--quiet", *COARSE).stderr, "")


class DamagedMatches(Program):
    def setUp(self):
        super().setUp()
        os.rename(self.path("bear.off"), self.path("a\x1bb.off"))
        done = self.run_it("match", "a\x1bb.off", "bear_bis.off", "--mirror", "forbid", "--out", "out", *COARSE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.write("points.csv", "label,x,y,z\nhead,0,2.1,0.1\n")

    def test_a_match_that_cannot_be(self):
        text, points = self.read("out", "match.json"), ("--points", "points.csv", "--out", "a.csv")

        def refuse(part, change):
            match = json.loads(text)
            change(match["matches"][0])
            self.write("out/match.json", json.dumps(match))
            self.expect_message(3, f"out/match.json: {part}", "transfer", "out/match.json", *points)

        weight = json.loads(text)["matches"][0]["warp"]["weights"]
        refuse("the warp of a match leads a pair", lambda match: match["warp"].update(weights=[[1e308, 0, 0], *weight[1:]]))
        refuse("a warp makes a plane, a line or a point", lambda match: match["warp"].update(affine=[[0] * 4] * 3))
        refuse("the confidence of a match is not from 0 to 1", lambda match: match.update(confidence=7))
        refuse("a match is told to be mirrored, but its map is not", lambda match: match.update(handedness="mirrored"))
        refuse("a match has no pairs", lambda match: match.update(pairs=[]))
        self.write("out/match.json", text)
        done = self.run_it("transfer", "out/match.json", *points)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn(" carried from a?b.off to bear_bis.off;", done.stdout)

    def test_points_and_meshes_endlessly_far(self):
        self.write("far.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1e308 0\n3 0 1 2\n")
        self.expect_message(3, "out/match.json: the match leads a point of far.off to no finite place", "transfer", "out/match.json",
                            "--mesh", "far.off", "--out", "a.ply", "--quiet")  # fmt: skip
        self.assertFalse(os.path.exists(self.path("a.ply")))
        self.write("points.csv", "label,x,y,z\nhead,0,2.1,0.1\nfar,1e300,0,0\n")
        done = self.run_it("transfer", "out/match.json", "--points", "points.csv", "--out", "a.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(self.read("a.csv"), r"\Alabel,[^\n]+\nhead,[-.\de]+,[^\n]+\nfar,,,,,0.000\n\Z")


if __name__ == "__main__":
    main()
