# SPDX-License-Identifier: MIT
# The program under test in a folder of its own with shapes in it. In: the program, its version, the folder of the examples' programs.
# Standard library only.
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import bear
from sanitizer import is_under_address_sanitizer

PROGRAM, VERSION, EXAMPLES = os.path.abspath(sys.argv[1]), sys.argv[2], os.path.abspath(sys.argv[3])
COARSE = ("--resolution", "64")  # enough for bears made of balls, and quick


limits_memory = unittest.skipIf(is_under_address_sanitizer(PROGRAM), "limits of memory do not go with AddressSanitizer")


class Program(unittest.TestCase):
    begins_with = ()  # words of a command whose results every test of the class needs; run once

    @classmethod
    def setUpClass(cls):
        beginning = tempfile.TemporaryDirectory()
        cls.addClassCleanup(beginning.cleanup)
        cls.beginning = beginning.name
        bear.write_all(cls.beginning)
        if cls.begins_with:
            subprocess.run([PROGRAM, *cls.begins_with], cwd=cls.beginning, check=True, stdout=subprocess.DEVNULL, timeout=300)

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        shutil.copytree(self.beginning, self.folder.name, dirs_exist_ok=True)

    def run_it(self, *words, program=PROGRAM, **how):
        how = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **how}
        return subprocess.run([program, *words], cwd=self.folder.name, text=True, timeout=300, **how)

    def in_own_mounts(self, mounts, script):
        """Runs a shell in which these commands mounted what nobody else sees: no root is needed, only namespaces."""
        self.write("script", "".join(f"{mount} || exit 99\n" for mount in mounts) + script + "\n")
        words = ["unshare", "--user", "--map-root-user", "--mount", "sh", "script"]
        done = subprocess.run(words, cwd=self.folder.name, capture_output=True, text=True, timeout=300)
        if done.returncode == 99 or "unshare" in done.stderr:
            print(f"SKIPPED {self.id()}: no user may mount here: {done.stderr}", file=sys.stderr)
            self.skipTest("no user may mount here")
        return done

    def path(self, *names):
        return os.path.join(self.folder.name, *names)

    def read(self, *names):
        with open(self.path(*names)) as file:
            return file.read()

    def write(self, name, content):
        with open(self.path(name), "wb" if isinstance(content, bytes) else "w") as file:
            file.write(content)

    def expect_message(self, code, part, *words):
        """The exit code, one sentence on stderr that holds `part`, and nothing on stdout."""
        done = self.run_it(*words)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assertRegex(done.stderr, r"\Ahomolog: [^\n]+\n\Z")
        self.assertIn(part, done.stderr)
        self.assertEqual(done.stdout, "")


def main():
    unittest.main(module="__main__", argv=sys.argv[:1] + sys.argv[4:])
