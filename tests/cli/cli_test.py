# SPDX-License-Identifier: MIT
# The program as a user meets it: exit codes, messages, files.
import csv
import json
import math
import os
import pty
import resource
import shlex
import signal
import subprocess
import unittest

import mesh_files
from program import COARSE, EXAMPLES, PROGRAM, VERSION, Program, limits_memory, main

VERBS = ("match", "symmetry", "points", "transfer", "params")
MATCH_FILES = {"match.json", "parts.json", "model.part.ply", "data.part.ply", "model.landmarks.csv", "data.landmarks.csv", "model.mrk.json", "data.mrk.json", "report.html"}
POINT_FILES = {"points.json", "points.csv", "points.mrk.json", "report.html"}


def warped(warp, x):
    """f(x) = affine [x; 1] + sum_k weights_k phi(|x - centres_k|)"""
    power = {"r": 1, "r3": 3}[warp["kernel"]]
    phi = [math.dist(x, centre) ** power for centre in warp["centres"]]
    straight = [sum(a * b for a, b in zip(row, (*x, 1))) for row in warp["affine"]]
    return [f + sum(w[axis] * p for w, p in zip(warp["weights"], phi)) for axis, f in enumerate(straight)]


class Usage(Program):
    def test_version(self):
        self.assertEqual(self.run_it("--version").stdout, f"homolog {VERSION}\n")

    def test_help_has_examples_for_every_verb(self):
        for words in ((), *((verb,) for verb in VERBS)):
            done = self.run_it(*words, "--help")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("\n  homolog ", done.stdout)

    def test_wrong_words(self):
        self.expect_message(2, "did you mean 'match'", "mtch", "bear.off", "bear.off")
        self.expect_message(2, "did you mean '--resolution'", "match", "bear.off", "bear.off", "--resolutoin", "64")
        self.expect_message(2, "did you mean '--mirror'", "match", "--miror=only", "bear.off")
        self.expect_message(2, "did you mean '--model-label'", "match", "bear.off", "--label", "1")
        self.expect_message(3, "-dash.off: there is no such file", "points", "--", "-dash.off")
        self.expect_message(2, "put '--quiet' before it", "points", "--", "-dash.off", "--quiet")
        self.expect_message(2, "unknown option '--frobnicate'", "points", "bear.off", "--frobnicate")
        self.expect_message(2, "match, symmetry, points, transfer, dense, morph or params")
        self.expect_message(2, "MODEL is required", "match")
        self.expect_message(2, "DATA", "match", "bear.off")
        self.expect_message(2, "--self", "match", "bear.off", "bear.off", "--self")
        self.expect_message(2, "--self", "match", "bear.off", "--self", "--data-label", "1")
        self.expect_message(2, "one file too many: 'c'", "match", "a", "b", "c")
        self.expect_message(2, "--out needs a value", "points", "bear.off", "--out")

    def test_wrong_values(self):
        self.expect_message(2, "'resolution' is '8', but must be", "points", "bear.off", "--resolution", "8")
        self.expect_message(2, "'resolution' is '64.5'", "points", "bear.off", "--resolution", "64.5")
        self.expect_message(2, "'sigma0' is 'nan'", "points", "bear.off", "--sigma0", "nan")
        self.expect_message(2, "allow, forbid or only", "match", "bear.off", "bear.off", "--mirror", "maybe")
        self.expect_message(2, "preset 'papr'", "points", "bear.off", "--preset", "papr")
        self.expect_message(2, "no name", "points", "bear.off", "--out", "")
        self.expect_message(2, "--threads is '-1'", "points", "bear.off", "--threads", "-1")
        self.expect_message(2, "--match is '0', but must be a whole number from 1", "morph", "match.json", "--match", "0", "--out", "a.glb")
        self.expect_message(2, "--label is 'x', but must be a whole number", "points", "bear.off", "--label", "x")

    def test_wrong_parts(self):
        for part in ("", "y", "y>", "w>0.5", "y>1.5", "y>-1", "y>0.5,", ",", "y=0.2", "y=0.2..", "y=1..2", "y>0.5z<1", "y>nan"):
            self.expect_message(2, f"part '{part}' is not understood", "points", "bear.off", "--part", part)
        self.expect_message(2, "leaves nothing", "points", "bear.off", "--part", "y>0.6,y<0.5")

    def test_params(self):
        text = self.run_it("params").stdout
        for item in json.loads(self.run_it("params", "--json").stdout):
            value = item["value"] if isinstance(item["value"], str) else format(item["value"], "g")
            for part in (item["name"], item["symbol"], value, item["unit"], item["sentence"]):
                self.assertIn(part, text)
        paper = {item["name"]: item["value"] for item in json.loads(self.run_it("params", "--preset", "paper", "--json").stdout)}
        self.assertEqual((paper["resolution"], paper["seeds"]), (128, "quadruples"))


class Failures(Program):
    def test_unusable_shapes(self):
        for name in ("missing.off", "empty.off", "garbage.off", "truncated.off", "infinite.off", "flat.off", "sheet.off", "huge.off"):
            with self.subTest(name):
                self.expect_message(3, name, "points", name, "--out", "new/folder", *COARSE)
                self.expect_message(3, name, "match", "plate.off", name, "--out", "new/folder", *COARSE)
        self.assertFalse(os.path.exists(self.path("new")))

    def test_unwritable_folder_is_told_before_the_shapes_are_read(self):
        self.expect_message(4, "bear.off/results", "match", "missing.off", "missing.off", "--out", "bear.off/results")
        self.expect_message(4, "bear.off", "points", "missing.off", "--out", "bear.off")

    def test_failed_write_leaves_nothing(self):
        def small_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (600, 600))

        done = self.run_it("points", "bear.off", "--out", "new", *COARSE, preexec_fn=small_files)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertRegex(done.stderr, r"homolog: cannot write '[^\n]+\n\Z")
        self.assertFalse(os.path.exists(self.path("new")))

    def test_interruption_leaves_nothing(self):
        words = [PROGRAM, "match", "open.off", "bear.off", "--out", "new/folder", *COARSE]
        with subprocess.Popen(words, cwd=self.folder.name, stderr=subprocess.PIPE, text=True) as running:
            self.assertIn("open.off is open", running.stderr.readline())  # it is in the middle of its work
            running.send_signal(signal.SIGINT)
        self.assertEqual(running.returncode, -signal.SIGINT)
        self.assertFalse(os.path.exists(self.path("new")))

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_standard_output(self):
        with open("/dev/full", "w") as full:
            self.assertEqual(self.run_it("params", stdout=full).returncode, 4)

    @limits_memory
    def test_too_little_memory_is_one_sentence(self):
        def little_memory():
            resource.setrlimit(resource.RLIMIT_AS, (400 << 20, 400 << 20))

        done = self.run_it("points", "bear.off", "--resolution", "1000", preexec_fn=little_memory)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("not enough memory", done.stderr)


class Results(Program):
    def landmark_labels(self, side):
        rows = list(csv.DictReader(self.read("out", f"{side}.landmarks.csv").splitlines()))
        markups = json.loads(self.read("out", f"{side}.mrk.json"))["markups"][0]["controlPoints"]
        self.assertEqual([row["label"] for row in rows], [point["label"] for point in markups])
        for row, point in zip(rows, markups):
            self.assertEqual([float(row[axis]) for axis in "xyz"], point["position"])
        return [row["label"] for row in rows]

    def test_match(self):
        done = self.run_it("match", "bear.off", self.path("bear_bis.off"), "--threads", "1", "--out", "out", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(set(os.listdir(self.path("out"))), MATCH_FILES)
        self.assertTrue(done.stdout.startswith("rank  pairs  confidence  handedness"))
        self.assertTrue(done.stdout.endswith("The report is out/report.html\n"))
        result = json.loads(self.read("out", "match.json"))
        self.assertEqual((result["model"]["file"], result["data"]["file"]), ("bear.off", "bear_bis.off"))
        self.assertEqual(len(done.stdout.splitlines()), len(result["matches"]) + 2)
        self.assertEqual(len(self.landmark_labels("model")), len(result["matches"][0]["pairs"]))
        self.assertEqual(self.landmark_labels("model"), self.landmark_labels("data"))
        self.assertNotIn(self.folder.name, "".join(self.read("out", name) for name in MATCH_FILES))
        for match in result["matches"]:
            self.warp_brings_pairs_together(match, result["model"], result["data"])
        self.same_bytes_from_two_threads_and_on_stdout()

    def warp_brings_pairs_together(self, match, model, data):
        """By what match.json alone tells, as another program would read it; each relation is one-to-one."""
        for pair in match["pairs"]:
            there = warped(match["warp"], model["points"][pair["model"]]["position"])
            self.assertLess(math.dist(there, data["points"][pair["data"]]["position"]), 0.05 * data["diagonal"])
        for side in ("model", "data"):
            self.assertEqual(len({pair[side] for pair in match["pairs"]}), len(match["pairs"]))

    def same_bytes_from_two_threads_and_on_stdout(self):
        done = self.run_it("match", "bear.off", "bear_bis.off", "--threads", "2", "--json", "--out", "again", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout, self.read("again", "match.json"))
        for name in MATCH_FILES:
            self.assertEqual(self.read("out", name), self.read("again", name), name)

    def test_points(self):
        done = self.run_it("points", "bear.off", "--out", "out", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(set(os.listdir(self.path("out"))), POINT_FILES)
        points = json.loads(self.read("out", "points.json"))["shape"]["points"]
        self.assertEqual(len(points), len(self.read("out", "points.csv").splitlines()) - 1)
        self.assertEqual(len(points), len(done.stdout.splitlines()) - 2)

    def open_terminal(self):
        try:
            return pty.openpty()
        except OSError as error:
            self.skipTest(f"this system gives no pseudo-terminal: {error}")

    def drain(self, terminal):
        """All that was shown; a terminal whose other side is closed ends with an error or with nothing."""
        shown = b""
        with open(terminal, "rb", buffering=0) as stream:
            try:
                while part := stream.read(1000):
                    shown += part
            except OSError:
                pass
        return shown.decode()

    def test_progress_is_shown_on_a_terminal_and_taken_away(self):
        for words, shown in ((), True), (("--quiet",), False):
            terminal, slave = self.open_terminal()
            done = self.run_it("points", "bear.off", *COARSE, *words, stderr=slave)
            os.close(slave)
            text = self.drain(terminal)
            self.assertEqual(done.returncode, 0)
            self.assertEqual("describing bear.off ..." in text, shown)
            self.assertEqual(text[-3:], "\033[K" if shown else "")

    def test_part_is_less_than_the_whole(self):
        def diagonal(*words):
            return json.loads(self.run_it("points", "bear.off", "--json", *COARSE, *words).stdout)["shape"]["diagonal"]

        self.assertLess(diagonal("--part", "y>0.5"), 0.9 * diagonal())

    def test_flags_win_over_the_preset_wherever_they_stand(self):
        first = self.run_it("points", "bear.off", "--json", "--resolution", "48", "--preset", "paper")
        last = self.run_it("points", "bear.off", "--json", "--preset", "paper", "--resolution", "48")
        parameters = json.loads(first.stdout)["parameters"]
        self.assertEqual((parameters["resolution"], parameters["seeds"]), (48, "quadruples"))
        self.assertEqual(first.stdout, last.stdout)

    def test_timing_is_a_table_on_stderr(self):
        self.assertEqual(self.run_it("match", "bear.off", "bear_bis.off", "--out", "out", *COARSE).returncode, 0)
        stored = ("reading match and meshes", "dense maps", "writing results", "all")
        for words, stages in (
            (("points", "bear.off"), ("reading bear.off", "voxels", "salient points", "descriptors", "body", "writing results", "all")),
            (("match", "bear.off", "bear_bis.off"), ("reading bear_bis.off", "seeds", "growth", "chamfer", "writing results", "all")),
            (("symmetry", "bear.off"), ("reading bear.off", "seeds", "growth", "chamfer", "writing results", "all")),
            (("dense", "out/match.json", "--out", "dense"), stored),
            (("morph", "out/match.json", "--out", "morph.glb"), stored),
            (("transfer", "out/match.json", "--points", "out/model.landmarks.csv", "--out", "carried.csv"), ("reading the match", "carrying", "all")),
        ):
            coarse = () if words[1] == "out/match.json" else COARSE
            plain, timed = self.run_it(*words, *coarse), self.run_it(*words, "--timing", "--quiet", *coarse)
            self.assertEqual((plain.returncode, timed.returncode), (0, 0), timed.stderr)
            self.assertEqual(timed.stdout, plain.stdout)
            for stage in stages:
                self.assertRegex(timed.stderr, rf"(?m)^{stage} +[0-9.]+ +[0-9.]+ +[0-9.]+")

    def test_open_mesh_is_told_unless_quiet(self):
        done = self.run_it("points", "open.off", *COARSE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"\Ahomolog: warning: open.off is open \([0-9.e-]+ % of its edges, [0-9]+ pieces?\); [0-9.e-]+ % of the inside was guessed\n\Z")
        self.assertEqual(self.run_it("points", "open.off", "--quiet", *COARSE).stderr, "")

    def test_a_doubtful_family_says_so(self):
        done = self.run_it("match", "bear.off", "plate.off", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\nNo match here is likely to be right: the highest confidence is 0\.[0-4][0-9]\.\n\Z")

    def test_nothing_found_still_writes_files(self):
        done = self.run_it("points", "plate.off", "--threshold", "1", "--out", "points", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (1, "homolog: nothing found: plate.off has no salient point; a lower --threshold or a higher --resolution may find some\n"))
        self.assertEqual(json.loads(self.read("points", "points.json"))["shape"]["points"], [])
        done = self.run_it("match", "plate.off", "bear.off", "--threshold", "1", "--out", "out", *COARSE)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"\Ahomolog: nothing found: plate.off has no salient point; [^\n]*\n\Z")
        self.assertEqual(json.loads(self.read("out", "match.json"))["matches"], [])
        self.assertEqual(self.landmark_labels("model"), [])
        self.assertEqual(set(os.listdir(self.path("out"))), MATCH_FILES)


class Examples(Program):
    def test_every_example_of_the_help_runs(self):
        with open(self.path("landmarks.csv"), "w") as file:
            file.write("label,x,y,z\nnose,0,1.3,0.98\n")
        with open(self.path("landmarks.mrk.json"), "w") as file:
            json.dump({"markups": [{"type": "Fiducial", "controlPoints": [{"label": "nose", "position": [0, 1.3, 0.98]}]}]}, file)
        lines = self.read("bear.off").splitlines()
        vertices, faces = (int(n) for n in lines[1].split()[:2])
        with open(self.path("painted.ply"), "w") as file:
            properties = "".join(f"property {kind}\n" for kind in ("float x", "float y", "float z", "int part"))
            file.write(f"ply\nformat ascii 1.0\nelement vertex {vertices}\n{properties}element face {faces}\n")
            file.write("property list uchar int vertex_indices\nend_header\n")
            file.write("\n".join([line + " 1" for line in lines[2 : 2 + vertices]] + lines[2 + vertices :]) + "\n")
        with open(self.path("painted.obj"), "w") as file:
            file.write("vt 0.5 0.5\n" + "".join(f"v {line}\n" for line in lines[2 : 2 + vertices]))
            file.write("".join("f " + " ".join(f"{int(c) + 1}/1" for c in line.split()[1:]) + "\n" for line in lines[2 + vertices :]))
        corners = [[int(c) for c in line.split()[1:4]] for line in lines[2 + vertices :]]
        places = [[float(x) for x in line.split()] for line in lines[2 : 2 + vertices]]
        with open(self.path("rigged.glb"), "wb") as file:
            file.write(mesh_files.rigged_glb(places, corners, neck=0.9, animated=False))
        with open(self.path("collection.tps"), "w") as file:
            file.write("LM3=1\n0 0 0\nID=other\nLM3=1\n0 1.3 0.98\nID=bear\n")
        lines = [line.strip() for words in ((), *((verb,) for verb in VERBS)) for line in self.run_it(*words, "--help").stdout.splitlines()]
        examples = [shlex.split(line)[1:] for line in dict.fromkeys(lines) if line.startswith("homolog ")]
        self.assertGreater(len(examples), 10)
        for words in examples:
            with self.subTest(" ".join(words)):
                coarse = words[0] not in ("params", "transfer", "dense", "morph") and "--resolution" not in words
                done = self.run_it(*words, *(COARSE if coarse else ()))
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertNotEqual(done.stdout, "")

    def test_examples_of_the_library_run(self):
        for words in (("example_01_match", "bear.off", "bear_bis.off"), ("example_02_stages", "bear.off"),
                      ("example_03_match_stages", "bear.off", "bear_bis.off")):
            done = subprocess.run([os.path.join(EXAMPLES, words[0]), *words[1:]], cwd=self.folder.name, capture_output=True, text=True, timeout=300)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertRegex(done.stdout, "match, confidence|salient points|\nmatch,")


if __name__ == "__main__":
    main()
