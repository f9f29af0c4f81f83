# SPDX-License-Identifier: MIT
# The same bytes of all results, whatever the number of threads, from run to run, whatever the order of options, and on processors with
# narrower vectors: glibc is told to do without (which changes the last bits of its exp and sin), and where qemu-user is installed the whole
# program runs on a processor of 2008.
import os
import shutil
import subprocess
import unittest

from program import COARSE, PROGRAM, Program, main

MATCH = ("match", "bear.off", "bear_bis.off")
NARROW = "glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX512BW,-AVX512DQ,-AVX2,-AVX,-FMA,-FMA4"


class SameBytes(Program):
    def results(self, *words, **how):
        done = self.run_it(*words, "--out", "out", **how)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        found = {name: self.read("out", name) for name in sorted(os.listdir(self.path("out")))}
        shutil.rmtree(self.path("out"))
        return found

    def test_for_any_number_of_threads_and_from_run_to_run(self):
        first = self.results(*MATCH, *COARSE, "--threads", "1")
        for threads in (1, 2, 3, 8, 0):
            self.assertEqual(self.results(*MATCH, *COARSE, "--threads", str(threads)), first, f"{threads} threads")

    def test_whatever_the_order_of_options(self):
        options = (*COARSE, "--mirror", "forbid", "--matches", "3", "--model-part", "y>0.4")
        first = self.results(*MATCH, *options)
        pairs = [options[i : i + 2] for i in range(0, len(options), 2)]
        backwards = [word for pair in reversed(pairs) for word in pair]
        self.assertEqual(self.results(*MATCH, *backwards), first)
        self.assertEqual(self.results("match", *backwards, *MATCH[1:]), first)
        self.assertEqual(self.results("match", *(f"{name}={value}" for name, value in pairs), *MATCH[1:]), first)

    def test_without_the_wide_vectors_of_the_c_library(self):
        narrow = self.results(*MATCH, *COARSE, env={**os.environ, "GLIBC_TUNABLES": NARROW})
        self.assertEqual(narrow, self.results(*MATCH, *COARSE))

    def test_on_an_old_processor(self):
        emulator = shutil.which("qemu-x86_64") or shutil.which("qemu-x86_64-static")
        if not emulator:
            self.skipTest("no qemu-user is installed, so no other processor was tried")
        coarse = ("--resolution", "48", "--threads", "1")
        for words, processor in ((("points", "bear.off", *coarse), "Nehalem"), ((*MATCH, *coarse), "Haswell")):
            first = self.results(*words)
            done = subprocess.run([emulator, "-cpu", processor, PROGRAM, *words, "--out", "out"], cwd=self.folder.name, capture_output=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual({name: self.read("out", name) for name in sorted(os.listdir(self.path("out")))}, first, processor)
            shutil.rmtree(self.path("out"))


if __name__ == "__main__":
    main()
