# SPDX-License-Identifier: MIT
# What goes wrong around the program: files that lie, disks that are full, folders that are not writable, processes that are killed.
import fcntl
import gzip
import json
import os
import shutil
import signal
import struct
import subprocess
import unittest
import zlib

import bear
import cloud_files
import fbx_files
import mesh_files
import volume_files
import vtk_files
from program import COARSE, PROGRAM, Program, limits_memory, main

NOBODY = 65534


class LyingFiles(Program):
    def refuse(self, name, content, part=""):
        self.write(name, content)
        with self.subTest(name):
            self.expect_message(3, part, "points", name, *COARSE)

    def test_counts_sizes_and_offsets(self):
        v, f = mesh_files.solid()
        announce = "the file is too short"
        self.refuse("count.off", bear.off(v, f).encode().replace(b"36 64 0", b"36 4000000000 0"), announce)
        self.refuse("count.stl", mesh_files.stl_binary(v, f)[:80] + b"\xff\xff\xff\xff" + mesh_files.stl_binary(v, f)[84:], announce)
        for form in ("ascii", "binary_little_endian", "binary_big_endian"):
            self.refuse("count.ply", mesh_files.ply(v, f, form).replace(b"vertex 36", b"vertex 4000000000"), announce)
        self.refuse("list.ply", mesh_files.ply(v, f, "binary_little_endian")[:-13] + b"\xff" + bytes(12), "does not fit into the file")
        self.refuse("corner.obj", mesh_files.obj(v, f) + b"f 1 2 4000000000\n", "does not exist")
        for old, new in ((b'"byteLength": 816', b'"byteLength": 4000000000'), (b'"byteOffset": 0', b'"byteOffset": 4000000000'),
                         (b'"count": 36', b'"count": 4000000000'), (b'"count": 36', b'"count": -1'),
                         (b'"bufferView": 1', b'"bufferView": 77'), (b'"mesh": 0', b'"mesh": 77')):  # fmt: skip
            text = mesh_files.gltf(v, f)
            self.assertIn(old, text)
            self.refuse("lie.gltf", text.replace(old, new, 1))
        glb = mesh_files.glb(v, f)
        self.refuse("length.glb", glb[:12] + struct.pack("<I", 0xFFFFFFFF) + glb[16:])
        fbx = fbx_files.fbx_binary(v, f)
        self.refuse("offset.fbx", fbx[:27] + struct.pack("<I", 0xFFFFFFF0) + fbx[31:])

    def test_a_node_that_is_its_own_child(self):
        v, f = mesh_files.solid()
        self.refuse("circle.gltf", mesh_files.gltf(v, f).replace(b'"mesh": 0, "tr', b'"mesh": 0, "children": [0], "tr'))

    def test_decompression_bomb(self):
        self.write("bomb.3mf", mesh_files.threemf('<?xml version="1.0"?><model><resources>' + " " * (200 << 20)))
        self.expect_message(3, "'3D/3dmodel.model' in it has more than the 100000000 bytes that are read", "points", "bomb.3mf", "--max-bytes", "1e8")
        self.expect_message(3, "it stops being XML here (no element found)", "points", "bomb.3mf")

    @limits_memory
    def test_what_is_unpacked_is_held_once_and_as_it_grows(self):
        self.write("bomb.3mf", mesh_files.threemf('<?xml version="1.0"?><model><resources>' + " " * (200 << 20)))
        self.expect_message(3, "it stops being XML here", "points", "bomb.3mf", "--max-memory", "450")
        self.expect_message(3, "not enough memory to read it", "points", "bomb.3mf", "--max-memory", "100")

    @limits_memory
    def test_bomb_of_entities(self):
        entities = "".join(f'<!ENTITY e{i + 1} "{f"&e{i};" * 10}">' for i in range(9))
        xml = f'<?xml version="1.0"?><!DOCTYPE VTKFile [<!ENTITY e0 "{"lol" * 100}">{entities}]><VTKFile type="PolyData"><PolyData>&e9;</PolyData></VTKFile>'
        self.refuse("lol.vtp", xml.encode())
        self.expect_message(3, "its entities unfold to far more than the file; export it again without any", "points", "lol.vtp")

    @limits_memory
    def test_bombs_of_volumes_and_vtp(self):
        zeros = bytes(300 << 20)
        limit = (*COARSE, "--max-memory", "200")
        self.write("behind.nii.gz", gzip.compress(volume_files.nifti() + zeros, 1))  # nobody asks for what is behind the voxels
        self.assertEqual(self.run_it("points", "behind.nii.gz", *limit).returncode, 0)
        nifti = bytearray(volume_files.nifti())
        struct.pack_into("<3h", nifti, 42, 800, 800, 800)
        self.write("within.nii.gz", gzip.compress(bytes(nifti) + zeros, 1))
        self.expect_message(3, "not enough memory to read it", "points", "within.nii.gz", *limit)
        vtp, packed = vtk_files.vtp(*mesh_files.solid(), "appended"), zlib.compress(zeros, 1)
        start = vtp.index(b'"raw">_') + 7
        _, unpacked, _, length = struct.unpack_from("<4I", vtp, start)
        for announced in (unpacked, len(zeros)):
            blocks = struct.pack("<4I", 1, announced, 0, len(packed)) + packed
            self.write("bomb.vtp", vtp[:start] + blocks + vtp[start + 16 + length :])
            self.expect_message(3, "bomb.vtp", "points", "bomb.vtp", *limit)

    def test_numbers_that_are_no_numbers_or_huge(self):
        v, f = mesh_files.solid()
        for bad in (b"nan", b"-inf", b"1e999"):
            self.refuse("number.off", bear.off(v, f).encode().replace(b"1.5 0.75 0.25", bad + b" 0 0"), "finite number")
        self.refuse("number.glb", mesh_files.glb(v, f).replace(struct.pack("<3f", 1.5, 0.75, 0.25), struct.pack("<3f", 1.5, float("nan"), 0)), "")
        self.refuse("far.off", bear.off([*v[:-1], (1.7e308, 0, 0)], f).encode(), "too large for numbers")
        self.refuse("flat.off", bear.off([(x * 1e-300, 1e300, z) for x, _, z in v], f).encode(), "")

    def test_scale_does_not_matter_from_tiny_to_huge(self):
        v, f = mesh_files.solid()
        counts = set()
        for power in (-60, -20, 0, 20, 60):  # by powers of two nothing is rounded
            self.write("scaled.off", bear.off([tuple(c * 2.0**power for c in x) for x in v], f).encode())
            done = self.run_it("points", "scaled.off", "--json", *COARSE)
            self.assertEqual(done.returncode, 0, done.stderr)
            counts.add(len(json.loads(done.stdout)["shape"]["points"]))
        self.assertEqual(len(counts), 1, counts)
        for power in (-300, -160, -25, 25, 160, 300):
            self.write("scaled.off", bear.off([tuple(c * 10.0**power for c in x) for x in v], f).encode())
            self.expect_message(3, "too small or too large for numbers", "match", "scaled.off", "bear.off", "--json", *COARSE)

    def test_materials_are_not_opened(self):
        os.mkfifo(self.path("none.mtl"))  # whoever opens it waits for ever
        self.write("solid.obj", mesh_files.obj(*mesh_files.solid()))
        self.assertEqual(self.run_it("points", "solid.obj", *COARSE).returncode, 0)

    def test_names_do_not_become_script(self):
        names = ["<img src=x onerror=alert(1)>.off", "<script>alert(1)<!--.off", "\"'&lt;\\u003c.off", "bad\udcff\x1b[2J\n.off"]
        plain = self.report("bear.off")
        for name in names:
            with self.subTest(repr(name)):
                shutil.copy(self.path("bear.off"), self.path(name))
                page = self.report(name)
                for mark in ("<script", "<img", "<!--", "</", "onerror="):
                    self.assertEqual(page.count(mark), plain.count(mark) + (mark == "onerror=" and mark in name), mark)

    def report(self, name):
        done = subprocess.run([PROGRAM, "points", name, "--out", "page", *COARSE], cwd=self.folder.name, capture_output=True, timeout=300)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.read("page", "report.html")


class Limits(Program):
    def test_each_refuses_with_its_option_and_the_numbers(self):
        for part, *words in (
            ("bytes, more than the 1000 that are read", "--max-bytes", "1000"),
            ("triangles are more than the 12 that are read", "--max-triangles", "12"),
            ("salient points, more than the 3 that are matched; a higher --threshold", "--max-points", "3"),
        ):
            self.expect_message(3, part, "points", "bear.off", *COARSE, *words)
        for option in ("--max-bytes", "--max-triangles", "--max-points"):
            self.expect_message(2, option, "points", "bear.off", option, "0")
        self.expect_message(2, "--max-triangles is '1.5', but must be a whole number", "points", "bear.off", "--max-triangles", "1.5")
        self.expect_message(3, "more than the 10 that are read", "points", "bear.off", "--max-triangles", "1e1")
        self.write("labels.nii", volume_files.nifti())
        self.expect_message(3, "24 x 16 x 12 voxels are more than the 10 that are read", "points", "labels.nii", "--max-voxels", "10")
        self.write("cloud.xyz", cloud_files.xyz())
        self.expect_message(3, "258 points are more than the 100 that are read", "points", "cloud.xyz", "--max-triangles", "100")
        self.expect_message(2, "'matches' is '101', but must be", "match", "bear.off", "bear.off", "--matches", "101")
        self.expect_message(2, "'resolution' is '1025', but must be", "points", "bear.off", "--resolution", "1025")


class Surroundings(Program):
    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_full_standard_error_costs_no_result(self):
        with open("/dev/full", "w") as full:
            for code, words in ((0, ("open.off", "--timing")), (3, ("nothing.off",))):
                done = subprocess.run([PROGRAM, "points", *words, *COARSE], cwd=self.folder.name, stdout=subprocess.DEVNULL, stderr=full)
                self.assertEqual(done.returncode, code, words)

    def on_a_disk_of(self, kilobytes, script):
        """Runs a shell in which small/ is a file system of that size."""
        os.makedirs(self.path("small"))
        return self.in_own_mounts([f"mount -t tmpfs -o size={kilobytes}k none small"], script)

    def test_full_disk(self):
        command = f"'{PROGRAM}' points bear.off --out small/out {' '.join(COARSE)}"
        done = self.on_a_disk_of(64, f"{command}; echo $?; find small -mindepth 1")
        self.assertRegex(done.stderr, r"\Ahomolog: cannot write '[^\n]+': No space left on device; make room, or choose another place\n\Z")
        self.assertEqual(done.stdout, "4\n")

    def test_read_only_folder(self):
        os.mkdir(self.path("locked"))
        os.chmod(self.path("locked"), 0o555)
        os.chmod(self.folder.name, 0o755)
        user = {"user": NOBODY} if os.geteuid() == 0 else {}
        user["program"] = shutil.copy(PROGRAM, self.path("homolog"))  # the build may lie where nobody else may look
        done = self.run_it("points", "bear.off", "--out", "locked/out", **user)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertRegex(done.stderr, r"\Ahomolog: cannot make the folder 'locked/out': Permission denied; choose one that you may write into\n\Z")
        done = self.run_it("points", "bear.off", "--out", "locked", **user)
        self.assertEqual((done.returncode, done.stderr), (4, "homolog: cannot write into the folder 'locked': Permission denied; choose one that you may write into\n"))

    def killed_while_it_writes(self):
        """Whether it was, into `out`; it may have been quicker."""
        words = [PROGRAM, "points", "bear.off", "--out", "out", *COARSE]
        with subprocess.Popen(words, cwd=self.folder.name, stdout=subprocess.DEVNULL) as running:
            before = set(os.listdir(self.path("out")))
            while running.poll() is None and not any(file.endswith(".partial") for file in set(os.listdir(self.path("out"))) - before):
                pass
            running.kill()
        return running.returncode == -signal.SIGKILL

    def test_killed_while_it_writes_it_leaves_every_result_whole(self):
        """The old one or the new one; what a kill leaves beside them begins with a dot."""
        wholes = {}
        for name in ("bear.off", "bear_bis.off"):
            self.assertEqual(self.run_it("points", name, "--out", name + ".out", *COARSE).returncode, 0)
            wholes[name] = {file: self.read(name + ".out", file) for file in os.listdir(self.path(name + ".out"))}
        os.rename(self.path("bear_bis.off.out"), self.path("out"))
        killed = 0
        for _ in range(20):
            killed += self.killed_while_it_writes()
            results = [name for name in os.listdir(self.path("out")) if not name.startswith(".")]
            self.assertEqual(sorted(results), sorted(wholes["bear.off"]))
            for name in results:
                self.assertIn(self.read("out", name), [whole[name] for whole in wholes.values()], name)
            if killed == 3:
                break
        self.assertGreater(killed, 0)

    def test_what_a_killed_one_leaves_the_next_one_removes(self):
        left = []
        while not left or not all(name.endswith(".partial") for name in left):  # killed before it wrote, or after
            shutil.rmtree(self.path("out"), ignore_errors=True)
            os.mkdir(self.path("out"))
            self.killed_while_it_writes()
            left = os.listdir(self.path("out"))
        self.assertTrue(left and all(name.startswith(".homolog.") and name.endswith(".partial") for name in left), left)
        self.assertEqual(self.run_it("points", "bear_bis.off", "--out", "out", *COARSE).returncode, 0)
        self.assertEqual(sorted(os.listdir(self.path("out"))), ["points.csv", "points.json", "points.mrk.json", "report.html"])

    def test_processes_with_one_folder_leave_the_results_of_one(self):
        shapes = ("bear.off", "bear_bis.off")
        alone = {}
        for name in shapes:
            self.assertEqual(self.run_it("points", name, "--out", name + ".out", *COARSE).returncode, 0)
            alone[name] = {file: self.read(name + ".out", file) for file in os.listdir(self.path(name + ".out"))}
        for _ in range(3):
            running = [subprocess.Popen([PROGRAM, "points", name, "--out", "out", *COARSE], cwd=self.folder.name, stdout=subprocess.DEVNULL)
                       for name in shapes * 2]  # fmt: skip
            self.assertEqual([process.wait() for process in running], [0] * 4)
            together = {file: self.read("out", file) for file in os.listdir(self.path("out"))}
            self.assertIn(together, alone.values())

    def test_who_fills_a_folder_waits_for_another_one(self):
        os.mkdir(self.path("out"))
        folder = os.open(self.path("out"), os.O_RDONLY)
        fcntl.flock(folder, fcntl.LOCK_EX)
        waiting = subprocess.Popen([PROGRAM, "points", "bear.off", "--out", "out", *COARSE], cwd=self.folder.name, stdout=subprocess.DEVNULL)
        self.assertEqual(self.run_it("points", "bear.off", "--out", "elsewhere", *COARSE).returncode, 0)  # as long as it would take
        self.assertEqual((waiting.poll(), os.listdir(self.path("out"))), (None, []))
        os.close(folder)
        self.assertEqual(waiting.wait(), 0)
        self.assertEqual(set(os.listdir(self.path("out"))), set(os.listdir(self.path("elsewhere"))))

    def test_a_reader_that_leaves_ends_the_program_in_silence(self):
        with open(self.path("errors"), "w") as errors:
            running = subprocess.Popen([PROGRAM, "points", "bear.off", *COARSE], cwd=self.folder.name, stdout=subprocess.PIPE, stderr=errors)
            running.stdout.close()
            self.assertEqual(running.wait(), -signal.SIGPIPE)
        self.assertEqual(self.read("errors"), "")
        done = subprocess.run(f"'{PROGRAM}' params --json | head -1", shell=True, cwd=self.folder.name, capture_output=True, text=True)
        self.assertEqual((done.stdout, done.stderr), ("[\n", ""))


if __name__ == "__main__":
    main()
