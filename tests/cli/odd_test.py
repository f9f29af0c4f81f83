# SPDX-License-Identifier: MIT
# What strangers throw at the program: each file of odd_files.py gives the points of the plain bear, or one sentence that says what to do.
import json
import os
import unittest

import bear
import odd_files
from program import COARSE, PROGRAM, Program, main


class OddFiles(Program):
    def test_a_right_answer_or_one_sentence(self):
        expected = self.answer("plain.off", bear.off(*odd_files.plain()).encode())[1]
        for name, content, words in odd_files.all_files():
            with self.subTest(name):
                code, points, said = self.answer(name, content)
                if words in (odd_files.POINTS, odd_files.OPEN):
                    self.assertEqual(code, 0)
                    self.assertRegex(said, r"\Ahomolog: warning: [^\n]+ is open [^\n]+\n\Z" if words is odd_files.OPEN else r"\A\Z")
                    self.assertGreaterEqual(odd_files.same(points, expected), 0.9)
                else:
                    self.assertEqual(code, 3)
                    self.assertRegex(said, r"\Ahomolog: [^\n]+\n\Z")
                    self.assertIn(words, said)

    def test_the_plain_bear_is_found_in_each(self):
        with open(self.path("plain.off"), "w") as file:
            file.write(bear.off(*odd_files.plain()))
        for name, content, words in odd_files.all_files():
            with self.subTest(name):
                with open(self.path(name), "wb") as file:
                    file.write(content)
                done = self.run_it("match", "plain.off", name, "--json", "--quiet", *COARSE)
                if words in (odd_files.POINTS, odd_files.OPEN):
                    self.assertEqual((done.returncode, done.stderr), (0, ""))
                    self.assertGreater(json.loads(done.stdout)["matches"][0]["confidence"], 0.9)
                else:
                    self.assertEqual((done.returncode, done.stdout), (3, ""))
                    self.assertIn(words, done.stderr)

    def answer(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)
        return odd_files.answer(PROGRAM, self.path(name), *COARSE)

    def test_places_far_from_the_origin_are_told_apart(self):
        head, counts, *lines = self.read("bear.off").splitlines()
        vertices = int(counts.split()[0])
        moved = [" ".join(repr(4e6 + float(x)) for x in line.split()) for line in lines[:vertices]]
        with open(self.path("far.off"), "w") as file:
            file.write("\n".join([head, counts, *moved, *lines[vertices:]]) + "\n")
        near, far = ([line.split()[1:4] for line in self.run_it("points", name, *COARSE).stdout.splitlines()[1:]] for name in ("bear.off", "far.off"))
        self.assertEqual(len(near), len(far))
        for place in near:
            self.assertLess(min(max(abs(float(x) + 4e6 - float(y)) for x, y in zip(place, other)) for other in far), 0.01)

    def test_what_is_no_file(self):
        os.symlink("loop.obj", self.path("loop.obj"))
        os.symlink("/dev/zero", self.path("zero.obj"))
        os.mkfifo(self.path("pipe.obj"))
        os.mkdir(self.path("folder.obj"))
        for name, words in (("loop.obj", "Too many levels of symbolic links"), ("a" * 300, "File name too long"), ("zero.obj", "not a regular file"), ("pipe.obj", "not a regular file"), ("folder.obj", "a directory")):  # fmt: skip
            self.expect_message(3, words, "points", name)


if __name__ == "__main__":
    main()
