# SPDX-License-Identifier: MIT
# No command replaces what it has read.
import os

from program import COARSE, Program, main


class Overwrite(Program):
    begins_with = ("match", "bear.off", "bear_bis.off", "--mirror", "forbid", "--out", "out", *COARSE)

    def worn(self):
        """bear.off as an OBJ, with a material and its picture."""
        lines = self.read("bear.off").splitlines()
        count = int(lines[1].split()[0])
        corners = ([int(c) + 1 for c in line.split()[1:]] for line in lines[2 + count :])
        self.write("worn.obj", "mtllib coat.mtl\nusemtl fur\nvt 0 0\n" + "".join(f"v {line}\n" for line in lines[2 : 2 + count])
                   + "".join("f " + " ".join(f"{c}/1" for c in face) + "\n" for face in corners))
        self.write("coat.mtl", "newmtl fur\nmap_Kd fur.png\n")
        self.write("fur.png", "bytes")

    def expect_kept(self, file, *words):
        before = self.read(file)
        self.expect_message(4, f"/{file}': it was read to make this, and would be lost; choose another name", *words)
        self.assertEqual(self.read(file), before)

    def test_files(self):
        self.worn()
        self.write("points.csv", "label,x,y,z\nhead,0,2.1,0.1\n")
        transfer, painted = ("transfer", "out/match.json"), "out/model.part.ply"
        self.expect_kept("worn.obj", *transfer, "--attributes", "worn.obj", "--out", "./worn.obj")
        self.expect_kept("coat.mtl", *transfer, "--attributes", "worn.obj", "--out", "./coat.obj")
        self.expect_kept("points.csv", *transfer, "--points", "points.csv", "--out", "./points.csv")
        for out in (painted, "out/data.part.ply"):
            self.expect_kept(out, *transfer, "--attributes", painted, "--out", f"./{out}")
        self.expect_kept(painted, *transfer, "--mesh", painted, "--out", f"./{painted}")
        os.rename(self.path("bear.off"), self.path("a.1.ply"))
        self.expect_kept("a.1.ply", "morph", "out/match.json", "--model", "a.1.ply", "--frames", "2", "--out", "./a.glb")
        self.assertFalse(os.path.exists(self.path("coat.obj")) or os.path.exists(self.path("a.glb")))

    def test_folders(self):
        self.expect_kept("out/model.part.ply", "match", "out/model.part.ply", "bear_bis.off", "--out", "./out", *COARSE)


if __name__ == "__main__":
    main()
