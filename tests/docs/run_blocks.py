#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs every ```bash and ```python block of the documentation, page by page, each page in a folder of its own.

    run_blocks.py PROGRAM [--keep FOLDER] [PAGE ...]

PROGRAM is the homolog that the commands mean; the Python that runs this one must have the package. Blocks of a page run in order, those
in Python with common names. A block right after `<!-- exit 1 -->` must end with that code, one after `<!-- not run: WHY -->` is left
out and told. --keep keeps the folders, and what each block printed as N.txt (N from 1), from which the site and its pictures are made.
The shapes come from Debian's package libcgal-demo, which is fetched once into build/demo.
"""
import argparse
import contextlib
import io
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"(?:^<!-- (?:exit (?P<code>\d+)|not run: (?P<why>.*?)) -->\n)?^```(?P<kind>bash|python)\n(?P<text>.*?)^```", re.S | re.M)


def shapes_package():
    """The .deb with the meshes, fetched if it is not there."""
    folder = ROOT / "build/demo"
    folder.mkdir(parents=True, exist_ok=True)
    if not list(folder.glob("libcgal-demo_*.deb")):
        subprocess.run(["apt-get", "-qq", "download", "libcgal-demo"], cwd=folder, check=True)
    return next(folder.glob("libcgal-demo_*.deb"))


def stand_ins(folder, program):
    """A folder for PATH: homolog is `program`, and `apt-get download` brings the package that is there already."""
    folder.mkdir()
    (folder / "homolog").symlink_to(program)
    apt = folder / "apt-get"
    apt.write_text(f'#!/bin/sh\n[ "$*" = "download libcgal-demo" ] && exec cp "{shapes_package()}" .\nexec /usr/bin/apt-get "$@"\n')
    apt.chmod(0o755)
    return folder


def run_bash(text, folder):
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def run_python(text, folder, names):
    printed, before = io.StringIO(), os.getcwd()
    os.chdir(folder)
    try:
        with contextlib.redirect_stdout(printed):
            exec(compile(text, "block", "exec"), names)
        return 0, printed.getvalue()
    except Exception:
        return 1, printed.getvalue() + traceback.format_exc()
    finally:
        os.chdir(before)


def run_page(page, folder):
    """Returns how many blocks ran and what went wrong, one sentence each."""
    folder.mkdir(parents=True)
    text, names, ran, wrong = page.read_text(encoding="utf-8"), {"__name__": "block"}, 0, []
    for block in BLOCK.finditer(text):
        line = text.count("\n", 0, block.start("text")) + 1
        if block["why"]:
            print(f"left out: {page.name}:{line} ({block['why']})")
            continue
        code, printed = run_bash(block["text"], folder) if block["kind"] == "bash" else run_python(block["text"], folder, names)
        ran += 1
        (folder / f"{ran}.txt").write_text(printed, encoding="utf-8")
        if code != int(block["code"] or 0):
            wrong.append(f"{page}:{line}: ended with {code}:\n{block['text']}{printed}")
    return ran, wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("pages", nargs="*", type=Path)
    options = parser.parse_intermixed_args()
    pages = [page for page in sorted(options.pages or (ROOT / "docs").rglob("*.md")) if BLOCK.search(page.read_text(encoding="utf-8"))]
    failures = 0
    with tempfile.TemporaryDirectory() as scratch:
        os.environ["PATH"] = f"{stand_ins(Path(scratch) / 'bin', options.program.resolve())}:{os.environ['PATH']}"
        for page in pages:
            start, kept = time.monotonic(), (options.keep or Path(scratch)) / page.stem
            shutil.rmtree(kept, ignore_errors=True)
            ran, wrong = run_page(page, kept)
            failures += len(wrong)
            print(*wrong, f"{'FAILED' if wrong else 'ok    '}  {page.name}: {ran} blocks, {time.monotonic() - start:.0f} s", sep="\n", flush=True)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
