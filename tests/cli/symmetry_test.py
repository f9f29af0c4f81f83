# SPDX-License-Identifier: MIT
# homolog symmetry as a user meets it.
import json
import os
import re

import bear
from program import COARSE, Program, main


class Symmetry(Program):
    def test_it_is_a_match_with_itself(self):
        verb = self.run_it("symmetry", "bear.off", "--json", *COARSE)
        flag = self.run_it("match", "bear.off", "--self", "--json", *COARSE)
        self.assertEqual(verb.returncode, 0, verb.stderr)
        self.assertEqual(verb.stdout, flag.stdout)
        model, data = (json.loads(verb.stdout)[side] for side in ("model", "data"))
        self.assertEqual(model["points"], data["points"][: len(model["points"])])  # followed points come after them
        self.assertEqual(model["diagonal"], data["diagonal"])

    def test_a_mirror_plane_is_printed_filed_and_drawn(self):
        with open(self.path("straight.off"), "w") as file:
            file.write(bear.mesh(bear.bear_balls((1.9, 0.9, 0.4))))
        done = self.run_it("symmetry", "straight.off", "--out", "out", *COARSE)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\n   1  mirrored in the plane [01]\.\d{4} x [+-]\d\.\d{4} y [+-]\d\.\d{4} z = \S+; it lies within ")
        symmetries = json.loads(self.read("out", "symmetry.json"))["symmetries"]
        self.assertEqual(len(symmetries), len(json.loads(self.read("out", "match.json"))["matches"]))
        self.assertEqual(symmetries[0]["kind"], "mirrored")
        self.assertGreater(symmetries[0]["normal"][0], 0.9999)
        self.assertLess(abs(symmetries[0]["offset"]), 0.01)
        self.assertLess(symmetries[0]["error"], 0.003)
        page = re.search(r'<script type="application/json" id="report">(.*?)</script>', self.read("out", "report.html"), re.S)[1]
        self.assertEqual(json.loads(page)["itself"]["symmetries"], symmetries)

    def test_two_shapes_have_none(self):
        self.run_it("match", "bear.off", "bear_bis.off", "--out", "out", *COARSE)
        self.assertFalse(os.path.exists(self.path("out", "symmetry.json")))


if __name__ == "__main__":
    main()
