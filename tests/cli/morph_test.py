# SPDX-License-Identifier: MIT
# homolog morph as a user meets it.
import json
import os
import struct

import bear
from program import COARSE, Program, main


class Morph(Program):
    """One bear that turns into the other, which is 2.5 times as large."""

    begins_with = ("match", "bear.off", "bear_bis.off", "--mirror", "forbid", "--out", "out", *COARSE)

    def model(self):
        lines = self.read("bear.off").splitlines()
        return [tuple(map(float, line.split())) for line in lines[2 : 2 + int(lines[1].split()[0])]]

    def positions(self, name):
        """Start and end of every vertex, out of the GLB."""
        with open(self.path(name), "rb") as file:
            content = file.read()
        size = struct.unpack_from("<I", content, 12)[0]
        gltf, binary = json.loads(content[20 : 20 + size]), content[28 + size :]

        def triples(accessor):
            view = gltf["bufferViews"][gltf["accessors"][accessor]["bufferView"]]
            values = struct.unpack_from(f"<{view['byteLength'] // 4}f", binary, view["byteOffset"])
            return list(zip(*[iter(values)] * 3))

        primitive, origin = gltf["meshes"][0]["primitives"][0], gltf["nodes"][0]["translation"]
        start = [tuple(o + x for o, x in zip(origin, v)) for v in triples(primitive["attributes"]["POSITION"])]
        end = [tuple(x + d for x, d in zip(v, way)) for v, way in zip(start, triples(primitive["targets"][0]["POSITION"]))]
        return start, end

    def share_near(self, positions, places, limit):
        near = [sum((a - b) ** 2 for a, b in zip(x, y)) ** 0.5 < limit for x, y in zip(positions, places)]
        return sum(near) / len(near)

    def test_glb_and_frames(self):
        done = self.run_it("morph", "out/match.json", "--colour", "--frames", "3", "--out", "morph.glb")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\Abear.off turns into bear_bis.off: \d+ of \d+ vertices have a place there; \d+ of \d+ triangles folded over, \d+ edges torn\n\Z")
        start, end = self.positions("morph.glb")
        there = [bear.turned(vertex) for vertex in self.model()]
        self.assertEqual(len(start), len(there))
        self.assertGreater(self.share_near(start, there, 1.5), 0.8)  # laid over it: a tenth of the height
        self.assertGreater(self.share_near(end, there, 0.75), 0.8)
        last = [tuple(map(float, line.split()[:3])) for line in self.read("morph.3.ply").split("end_header\n")[1].splitlines()[: len(end)]]
        self.assertEqual(self.share_near(last, end, 1e-4), 1)
        self.assertEqual(sorted(name for name in os.listdir(self.folder.name) if name.startswith("morph")),
                         ["morph.1.ply", "morph.2.ply", "morph.3.ply", "morph.glb"])

    def test_wrong_usage_and_files(self):
        match = "out/match.json"
        self.expect_message(2, "--out is required", "morph", match)
        self.expect_message(2, "written as .glb, not as 'a.ply'", "morph", match, "--out", "a.ply")
        for wrong in "1", "1001", "2.5", "abc", "":
            self.expect_message(2, f"--frames is '{wrong}', but must be a whole number from 2 to 1000", "morph", match, "--frames", wrong, "--out", "a.glb")
        self.expect_message(2, "--match is 99", "morph", match, "--match", "99", "--out", "a.glb")
        self.expect_message(3, "name that one", "morph", match, "--data", "plate.off", "--out", "a.glb")
        self.expect_message(3, "bear_bis.off: it was the data of this match, not the model; exchange --model and --data",
                            "morph", match, "--model", "bear_bis.off", "--data", "bear.off", "--out", "a.glb")
        self.expect_message(4, "cannot write 'none/a.glb'", "morph", match, "--out", "none/a.glb")
        self.assertFalse(os.path.exists(self.path("a.glb")))


if __name__ == "__main__":
    main()
