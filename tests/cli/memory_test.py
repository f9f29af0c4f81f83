# SPDX-License-Identifier: MIT
# Memory that ends: by --max-memory, and by default where the machine or its container has no more.
import unittest

import mesh_files
from program import COARSE, PROGRAM, Program, limits_memory, main

FINE = ("--resolution", "1000")  # which takes gibibytes
REFUSED = (3, "homolog: bear.off: not enough memory to describe it; a lower --resolution needs less, and --max-memory may allow more\n")


@limits_memory
class MaxMemory(Program):
    def test_memory_that_ends_while_lists_are_destroyed(self):
        with open(self.path("lists.gltf"), "w") as file:
            file.write('{"asset":{"version":"2.0"},"x":[' + "[]," * 2_000_000 + "0]}")
        self.expect_message(3, "not enough memory", "points", "lists.gltf", "--max-memory", "100")

    def test_too_little_memory_is_refused(self):
        self.expect_message(3, "bear.off: not enough memory to describe it; a lower --resolution needs less", "points", "bear.off", *FINE, "--max-memory", "200")

    def test_wherever_memory_ends_there_is_one_sentence(self):
        with open(self.path("bear.dae"), "wb") as file:
            file.write(mesh_files.collada(*mesh_files.solid()))
        for threads in ("1", "2"):
            for name in ("bear.off", "bear.dae"):
                for mebibytes in range(12, 48, 2):
                    done = self.run_it("points", name, "--resolution", "128", "--threads", threads, "--max-memory", str(mebibytes))
                    if done.returncode == 0:
                        break
                    self.assertEqual(done.returncode, 3, (threads, mebibytes, done.stderr))
                    self.assertRegex(done.stderr, r"\Ahomolog: [^\n]*not enough memory[^\n]*\n\Z")

    def test_enough_is_enough(self):
        words = ("--max-bytes", "10000000", "--max-triangles", "100000", "--max-points", "1000", "--max-memory", "2000")
        self.assertEqual(self.run_it("points", "bear.off", *COARSE, *words).stdout, self.run_it("points", "bear.off", *COARSE).stdout)


@limits_memory
class ByDefault(Program):
    """In a shell that sees another machine around it."""

    def run_where(self, *mounts, words=FINE):
        done = self.in_own_mounts(mounts, f"exec '{PROGRAM}' points bear.off --json {' '.join(words)}")
        return done.returncode, done.stderr

    def machine(self, mebibytes, swap):
        available = "" if mebibytes is None else f"MemAvailable: {mebibytes << 10} kB\n"
        self.write("meminfo", f"MemTotal: 64000000 kB\n{available}SwapTotal: 9000000 kB\nSwapFree: {swap << 10} kB\n")
        return "mount --bind meminfo /proc/meminfo"

    def container(self, group, file, bytes_allowed):
        """With that limit in the outermost group of those that a process stands in."""
        return "mount -t tmpfs none /sys/fs/cgroup", f"mkdir -p /sys/fs/cgroup{group}", f"echo {bytes_allowed} >/sys/fs/cgroup{group}/{file}"

    def test_no_more_than_the_machine_has_free(self):
        self.assertEqual(self.run_where(self.machine(100, 0)), REFUSED)
        self.assertEqual(self.run_where(self.machine(50, 50)), REFUSED)
        for mebibytes, swap in ((1000, 0), (0, 1000), (None, 10)):  # the last machine does not tell
            self.assertEqual(self.run_where(self.machine(mebibytes, swap), words=COARSE), (0, ""))

    def test_no_more_than_the_container_may_have(self):
        with open("/proc/self/cgroup") as groups:
            controllers = {name for line in groups for name in line.split(":")[1].split(",")}
        versions = {"": ("", "memory.max"), "memory": ("/memory", "memory.limit_in_bytes")}
        if not controllers & versions.keys():
            self.skipTest("no control group here counts memory")
        for version in controllers & versions.keys():
            with self.subTest(version):
                self.assertEqual(self.run_where(*self.container(*versions[version], 100 << 20)), REFUSED)
                for much in ("max", 1 << 30, 9223372036854771712):
                    self.assertEqual(self.run_where(*self.container(*versions[version], much), words=COARSE), (0, ""))

    def test_an_option_says_otherwise(self):
        for mebibytes in (0, 1000):
            self.assertEqual(self.run_where(self.machine(10, 0), words=(*COARSE, "--max-memory", str(mebibytes))), (0, ""))


if __name__ == "__main__":
    main()
