# SPDX-License-Identifier: MIT
# homolog transfer as a user meets it.
import csv
import json
import math
import os

import bear
import mesh_files
from program import COARSE, Program, main


class Transfer(Program):
    """Landmarks and a mesh carried by a match of the upper half of one bear with the other, which is 2.5 times as large."""

    begins_with = ("match", "bear.off", "bear_bis.off", "--model-part", "y>0.5", "--mirror", "forbid", "--out", "out", *COARSE)
    HEAD, NECK, FOOT = (0, 2.1, 0.1), (0.3, 1.2, 0.4), (0.75, -2, 0.9)

    def setUp(self):
        super().setUp()
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
        self.assertEqual(done.stdout, "2 of 4 points carried from bear.off to bear_bis.off; 1 outside the covered part, 1 missing before\n")
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

    def test_a_mesh_that_states_ras_keeps_its_numbers_and_its_points_say_so(self):
        lines = self.read("bear.off").split("\n", 2)
        count = [int(n) for n in lines[1].split()[:2]]
        rows = lines[2].split("\n")
        with open(self.path("ras.obj"), "w") as file:
            file.write("# 3D Slicer output. SPACE=RAS\n")
            file.writelines(f"v {row}\n" for row in rows[:count[0]])
            file.writelines("f " + " ".join(str(int(n) + 1) for n in row.split()[1:4]) + "\n" for row in rows[count[0]:count[0] + count[1]])
        self.run_it("match", "ras.obj", "bear_bis.off", "--mirror", "forbid", "--out", "ras", *COARSE)
        x, y, z = self.HEAD
        for system, position in (("RAS", [x, y, z]), ("LPS", [-x, -y, z])):
            with open(self.path("head.mrk.json"), "w") as file:
                point = {"label": "head", "position": position}
                json.dump({"markups": [{"coordinateSystem": system, "controlPoints": [point]}]}, file)
            done = self.run_it("transfer", "ras/match.json", "--points", "head.mrk.json", "--out", "there.mrk.json")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            there = json.loads(self.read("there.mrk.json"))["markups"][0]
            self.assertEqual(there["coordinateSystem"], "LPS")
            self.assertLess(math.dist(there["controlPoints"][0]["position"], bear.turned(self.HEAD)), 0.5)
        self.assertEqual(json.loads(self.read("ras", "model.mrk.json"))["markups"][0]["coordinateSystem"], "RAS")

    def test_markups_keep_their_lists_types_and_units(self):
        with open(self.path("two.mrk.json"), "w") as file:
            point = lambda place: {"position": place, "label": "ear", "description": "its tip", "locked": True, "visibility": False}
            markup = lambda type, *places: {"type": type, "coordinateUnits": "um", "controlPoints": [point(p) for p in places]}
            json.dump({"markups": [markup("Curve", [-self.HEAD[0], *self.HEAD[1:]], self.NECK), markup("Fiducial", self.FOOT)]}, file)
        transfer = ("transfer", "out/match.json", "--points", "two.mrk.json", "--out")
        done = self.run_it(*transfer, "there.mrk.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        lists = json.loads(self.read("there.mrk.json"))["markups"]
        self.assertEqual([(m["type"], m["coordinateUnits"], len(m["controlPoints"])) for m in lists], [("Curve", "um", 2), ("Fiducial", "um", 1)])
        point = lists[0]["controlPoints"][0]
        self.assertEqual([point[key] for key in ("label", "selected", "locked", "visibility")], ["ear", True, True, False])
        self.assertRegex(point["description"], r"^its tip; expected error \S+, coverage \S+$")
        done = self.run_it(*transfer, "there.csv")
        self.assertIn("two.mrk.json: what it holds is written as plain points, one list after the other", done.stderr)

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
        self.expect_message(3, "it holds 2 specimens; say which one is meant by its name or number (--specimen; in Python specimen=): 1 b0, 2 b1", *transfer)
        self.expect_message(3, "it holds no specimen 'b7'", *transfer, "--specimen", "b7")
        self.expect_message(3, "it holds the points of one specimen; leave the specimen out", "transfer", "out/match.json", "--points", "points.csv", "--out", "a.csv", "--specimen", "1")
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

    def painted(self):
        """bear.off with a height, the colour red where that is positive, and a label a side."""
        lines = self.read("bear.off").splitlines()
        vertices, faces = (int(n) for n in lines[1].split()[:2])
        with open(self.path("painted.ply"), "w") as file:
            file.write(f"ply\nformat ascii 1.0\nelement vertex {vertices}\n" + "".join(f"property float {axis}\n" for axis in "xyz"))
            file.write("".join(f"property uchar {colour}\n" for colour in ("red", "green", "blue")))
            file.write(f"property int side\nproperty float height\nelement face {faces}\nproperty list uchar int vertex_indices\nend_header\n")
            for line in lines[2 : 2 + vertices]:
                x, y = map(float, line.split()[:2])
                file.write(f"{line} {255 if y > 1 else 0} 0 0 {7 if x > 0 else 900} {y}\n")
            file.write("\n".join(lines[2 + vertices :]) + "\n")

    def test_attributes(self):
        self.painted()
        done = self.run_it("transfer", "out/match.json", "--attributes", "painted.ply", "--out", "carried.ply")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\Acolours, labels side, values height carried from painted.ply to \d+ of \d+ vertices of bear_bis.off; \d+ have none")
        vertices = [line.split() for line in self.read("carried.ply").split("end_header\n")[1].splitlines()]
        vertices = [v for v in vertices if len(v) == 9]
        there = [v for v in vertices if v[8] == "1"]
        self.assertGreater(len(there), 0.3 * len(vertices))
        self.assertEqual({v[6] for v in vertices}, {"7", "900", "-1"})
        self.assertEqual({(v[6], v[7]) for v in vertices if v[8] == "0"}, {("-1", "nan")})

        def at_rest(v):  # what bear.turned() turned
            x, y, z = ((float(c) - shift) / 2.5 for c, shift in zip(v[:3], (10, -3, 1)))
            y, z = 5 / 13 * y + 12 / 13 * z, 5 / 13 * z - 12 / 13 * y
            return 0.8 * x + 0.6 * y, 0.8 * y - 0.6 * x

        near = [abs(at_rest(v)[1] - float(v[7])) < 0.2 for v in there]  # a twentieth of the height
        self.assertGreater(sum(near) / len(near), 0.9)
        right = [(v[6] == "7") == (at_rest(v)[0] > 0) for v in there]
        self.assertGreater(sum(right) / len(right), 0.9)

    def test_uvs_and_their_pictures(self):
        lines = self.read("bear.off").splitlines()
        count = int(lines[1].split()[0])
        vertices = [tuple(map(float, line.split())) for line in lines[2 : 2 + count]]
        with open(self.path("painted.obj"), "w") as file:  # two islands: u below 0.5 where x < 0, above where not
            file.write("mtllib painted.mtl\nusemtl fur\n" + "".join("v {} {} {}\n".format(*v) for v in vertices))
            file.write("".join(f"vt {x / 10 + shift} {y / 10 + 0.5}\n" for shift in (0.25, 0.75) for x, y, _ in vertices))
            for face in lines[2 + count :]:
                corners = [int(c) for c in face.split()[1:]]
                island = count if sum(vertices[c][0] for c in corners) > 0 else 0
                file.write("f " + " ".join(f"{c + 1}/{c + 1 + island}" for c in corners) + "\n")
        with open(self.path("painted.mtl"), "w") as file:
            file.write("newmtl fur\nmap_Kd fur.png\n")
        transfer = ("transfer", "out/match.json", "--attributes", "painted.obj", "--out", "carried.obj")
        done = self.run_it(*transfer)
        self.assertEqual((done.returncode, done.stderr), (0, "homolog: warning: painted.obj names fur.png, which is not there\n"))
        with open(self.path("fur.png"), "w") as file:
            file.write("no picture, but bytes")
        done = self.run_it(*transfer)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\AUVs, 1 material carried from painted.obj [^\n]*\n\d+ of \d+ triangles have UVs\n\Z")
        self.assertEqual(self.read("carried.fur.png"), "no picture, but bytes")
        self.assertIn("map_Kd carried.fur.png\n", self.read("carried.mtl"))
        words = [line.split() for line in self.read("carried.obj").splitlines()]
        u = [float(w[1]) for w in words if w[0] == "vt"]
        faces = [[u[int(c.split("/")[1]) - 1] for c in w[1:]] for w in words if w[0] == "f" and "/" in w[1]]
        self.assertGreater(len(faces), 1000)
        self.assertEqual([us for us in faces if min(us) < 0.5 < max(us)], [])
        self.assertIn(["usemtl", "not_carried"], words)
        with open(self.path("painted.mtl"), "w") as file:
            file.write("newmtl fur\nmap_Kd -s 2 2 1 /etc/passwd\n")
        done = self.run_it(*transfer)
        self.assertRegex(done.stderr, "not carried: -s of map_Kd in painted.mtl\n.* the picture '/etc/passwd', which lies outside the folder")
        self.assertIn("UVs, 1 material carried", done.stdout)

    def test_a_skin_and_a_shape_key(self):
        lines = self.read("bear.off").splitlines()
        count = int(lines[1].split()[0])
        vertices = [tuple(map(float, line.split())) for line in lines[2 : 2 + count]]
        faces = [tuple(map(int, line.split()[1:])) for line in lines[2 + count :]]
        with open(self.path("rigged.glb"), "wb") as file:
            file.write(mesh_files.rigged_glb(vertices, faces, neck=0.9))
        done = self.run_it("transfer", "out/match.json", "--attributes", "rigged.glb", "--out", "carried.glb")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("weights of 2 joints, 1 shape key, 1 animation carried from rigged.glb", done.stdout)
        with open(self.path("carried.glb"), "rb") as file:
            scene, table = mesh_files.read_glb(file.read())
        self.assertEqual([node["name"] for node in scene["nodes"]], ["bear_bis", "rig", "body", "head"])
        primitive = scene["meshes"][0]["primitives"][0]
        self.assertEqual(scene["meshes"][0]["extras"]["targetNames"], ["grow"])
        places = table(primitive["attributes"]["POSITION"])
        weights = table(primitive["attributes"]["WEIGHTS_0"])
        self.assertLess(max(abs(sum(row) - 1) for row in weights), 1e-5)
        head = table(scene["skins"][0]["inverseBindMatrices"])[1]
        neck = [-sum(head[4 * axis + k] * head[12 + k] for k in range(3)) for axis in range(3)]
        self.assertLess(self.distance(dict(zip("xyz", neck)), bear.turned((0, 0.9, 0))), 0.5)  # a twentieth of the height
        (animation,) = scene["animations"]
        self.assertEqual(animation["channels"][0]["target"], {"node": 2, "path": "translation"})
        leap = table(animation["samplers"][0]["output"])
        up = dict(zip("xyz", (end - start for start, end in zip(*leap))))
        origin, above = bear.turned((0, 0, 0)), bear.turned((0, 1, 0))
        self.assertLess(self.distance(up, [a - o for o, a in zip(origin, above)]), 0.5)  # a fifth of the leap
        moved = [(sum(c * c for c in d) ** 0.5, p) for d, p in zip(table(primitive["targets"][0]["POSITION"]), places)]
        length, top = max(moved)
        self.assertAlmostEqual(length / 2.5, 0.5, delta=0.1)  # of the giver's, and the receiver is 2.5 times as large
        highest = max(v[1] for v in vertices)  # of both ears, which move as far
        tips = [bear.turned(v) for v in vertices if v[1] > highest - 1e-6]
        self.assertLess(min(self.distance(dict(zip("xyz", top)), tip) for tip in tips), 1)
        done = self.run_it("transfer", "out/match.json", "--attributes", "rigged.glb", "--out", "carried.ply")
        self.assertIn("weights, joints, shape keys and animations are written to a .glb or .gltf alone", done.stderr)

    def test_attributes_that_cannot_be_carried(self):
        self.painted()
        match, painted = "out/match.json", ("--attributes", "painted.ply")
        self.expect_message(2, "either --points or --mesh or --attributes", "transfer", match, *painted, "--mesh", "bear.off", "--out", "a.ply")
        self.expect_message(2, "attributes are written as .ply, .obj, .glb or .gltf, not as 'a.csv'", "transfer", match, *painted, "--out", "a.csv")
        self.expect_message(2, "--onto goes with --attributes", "transfer", match, "--points", "points.csv", "--onto", "bear.off", "--out", "a.csv")
        self.expect_message(2, "--labels goes with --attributes", "transfer", match, "--points", "points.csv", "--labels", "a", "--out", "a.csv")
        self.expect_message(3, "it has no field 'age'; it has colours, labels side, values height", "transfer", match, *painted, "--labels", "age", "--out", "a.ply")
        self.expect_message(3, "are read from .ply, .obj, .gltf and .glb", "transfer", match, "--attributes", "bear.off", "--out", "a.ply")
        with open(self.path("bad.glb"), "wb") as file:
            file.write(b"glTF\2\0\0\0")
        self.expect_message(3, "bad.glb: ", "transfer", match, "--attributes", "bad.glb", "--out", "a.ply")
        self.assertFalse(os.path.exists(self.path("a.ply")))

    def test_meshes_that_lie_elsewhere_are_refused(self):
        self.painted()
        head, rest = self.read("painted.ply").split("end_header\n")
        rows, count = rest.splitlines(), int(self.read("bear.off").split()[1])
        with open(self.path("z_up.ply"), "w") as file:  # as Blender saves what it shows
            turned = [f"{x} {-float(z)} {y} {others}" for x, y, z, others in (row.split(None, 3) for row in rows[:count])]
            file.write(head + "end_header\n" + "\n".join(turned + rows[count:]) + "\n")
        match, why = "out/match.json", "z_up.ply: it does not lie where bear.off lay when that was matched, but would if turned from Z up to Y up"
        self.expect_message(3, why, "transfer", match, "--attributes", "z_up.ply", "--out", "a.ply")
        self.expect_message(3, why, "transfer", match, "--mesh", "z_up.ply", "--out", "a.ply")
        self.expect_message(3, why, "dense", match, "--model", "z_up.ply", "--out", "dense")
        self.expect_message(3, "where bear_bis.off lay", "transfer", match, "--attributes", "painted.ply", "--onto", "bear.off", "--out", "a.ply")
        self.expect_message(3, "where bear_bis.off lay", "transfer", match, "--attributes", "painted.ply", "--inverse", "--out", "a.ply")
        with open(self.path("heart.off"), "w") as file:  # what lies within is carried by its points
            file.write("OFF\n4 4 0\n0 1 0\n.1 1 0\n0 1.1 0\n0 1 .1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")
        done = self.run_it("transfer", match, "--mesh", "heart.off", "--out", "a.ply")
        self.assertEqual(done.returncode, 0)
        self.assertIn("warning: heart.off: it does not lie where bear.off lay when that was matched; save", done.stderr)

    def test_wrong_usage_and_files(self):
        match, points = "out/match.json", ("--points", "points.csv")
        self.expect_message(2, "--out is required", "transfer", match, *points)
        self.expect_message(2, "either --points or --mesh", "transfer", match, "--out", "a.csv")
        self.expect_message(2, ".csv, .mrk.json, .tps, .pts (Landmark Editor) or .txt", "transfer", match, *points, "--out", "a.ply")
        self.expect_message(2, "written as .ply", "transfer", match, "--mesh", "bear.off", "--out", "a.obj")
        self.expect_message(2, "--match is 99", "transfer", match, *points, "--match", "99", "--out", "a.csv")
        self.expect_message(3, "out: this is a directory", "transfer", "out", *points, "--out", "a.csv")
        self.expect_message(3, "bear.off: this is not a file of matches", "transfer", "bear.off", *points, "--out", "a.csv")
        for what, file in (("--mesh", "bear.off"), ("--attributes", "bear.off")):
            limited = ("transfer", match, what, file, "--out", "a.ply", "--max-bytes", "1000")
            self.expect_message(3, "bytes, more than the 1000 that are read", *limited)
        self.expect_message(3, "points are read from", "transfer", match, "--points", "bear.off", "--out", "a.csv")
        self.expect_message(4, "cannot write 'none/a.csv'", "transfer", match, *points, "--out", "none/a.csv")
        self.assertFalse(os.path.exists(self.path("a.csv")))

    def test_points_of_another_shape_are_told(self):
        with open(self.path("far.csv"), "w") as file:
            file.write("label,x,y,z\na,900,0,0\n")
        done = self.run_it("transfer", "out/match.json", "--points", "far.csv", "--out", "a.csv")
        self.assertEqual(done.returncode, 1)
        self.assertIn("are the points those of bear.off?", done.stderr)
        self.assertIn("warning: 1 of 1 points of far.csv are farther from bear.off than a tenth of its diagonal", done.stderr)
        os.remove(self.path("out", "parts.json"))
        done = self.run_it("transfer", "out/match.json", "--points", "points.csv", "--out", "a.csv")
        self.assertEqual(done.returncode, 0)
        self.assertIn("warning: no parts.json", done.stderr)


if __name__ == "__main__":
    main()
