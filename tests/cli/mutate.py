# SPDX-License-Identifier: MIT
# Damaged files through the whole program: shapes of every format of mesh_files.py, landmarks, and a match that was found before, changed at
# random but the same for the same seed. A run must end with 0, 1 or 3, say no more than sentences, and stay within limits of memory and processor time. What breaks that is kept.
#   python3 tests/cli/mutate.py build/release/cli/homolog [--files N] [--seed S] [--only NAME] [--keep FOLDER]
# Standard library only.
import argparse
import collections
import os
import random
import re
import resource
import subprocess
import sys
import tempfile

import mesh_files
import stored_files
import volume_files
from sanitizer import is_under_address_sanitizer

MEMORY, SECONDS = 1 << 30, 10
LIES = [b"-1", b"0", b"1e300", b"-1e-300", b"nan", b"inf", b"4294967295", b"99999999999999999999", b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f",
        b"\0\0\0\x80", b"\0", b"\n", b'"', b"../../x", b"\0\0\xc0\x7f", b"65536", b"[[[[", b"</"]  # fmt: skip


def damaged(content, dice):
    content = bytearray(content)
    for _ in range(dice.choice((1, 1, 2, 4, 16))):
        at = dice.randrange(len(content) + 1)
        end = min(len(content), at + dice.randrange(1, 17))
        kind = dice.randrange(7)
        if kind == 0 and at < len(content):
            content[at] ^= 1 << dice.randrange(8)
        elif kind == 1:
            del content[at:end]
        elif kind == 2:
            content[at:at] = content[at:end] * dice.choice((1, 2, 100))
        elif kind == 3:
            lie = dice.choice(LIES)
            content[at : at + len(lie)] = lie
        elif kind == 4 and (numbers := list(re.finditer(rb"-?\d+(\.\d+)?", bytes(content)))):
            number = dice.choice(numbers)
            content[number.start() : number.end()] = dice.choice(LIES)
        elif kind == 5:
            content[at:end] = bytes(dice.randrange(256) for _ in range(end - at))
        elif dice.randrange(4) == 0:
            del content[at:]
    return bytes(content)


def damaged_inside(name, content, dice):
    """An archive is damaged in its one mesh half of the time: else little but its check sums would be tried."""
    if name.endswith(".3mf") and dice.randrange(2):
        return mesh_files.threemf(damaged(mesh_files.model_of_3mf(*mesh_files.solid()).encode(), dice))
    return damaged(content, dice)


def commands(name):
    """What is run on a file, by turns; the rest lies beside it, sound."""
    transfer = ("--out", "carried.csv", "--threads", "1")
    if name.startswith("landmarks."):
        return [("transfer", "match.json", "--points", name, *transfer)]
    meshes = ("match.json", "--model", "solid.off", "--data", "solid.off", "--threads", "1", "--out")
    if name in ("match.json", "parts.json"):
        return [("transfer", "match.json", "--points", "landmarks.csv", *transfer), ("dense", *meshes, "dense"), ("morph", *meshes, "morph.glb")]
    points = ("points", name, "--resolution", "32", "--threads", "1")
    worn = ("transfer", "match.json", "--attributes", name, "--onto", "solid.off", "--out", "worn.glb", "--threads", "1")
    return [points, worn] if name == "rigged.glb" else [points]


def complaint(words, folder, memory, seconds):
    """What is wrong with how the program took the file, empty if nothing; and how it ended."""

    def limit():
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
        os.nice(5)

    try:
        done = subprocess.run(words, cwd=folder, capture_output=True, preexec_fn=limit, timeout=60 * seconds)
    except subprocess.TimeoutExpired:
        return "hangs", None
    said = done.stderr.decode(errors="replace")
    if done.returncode not in (0, 1, 3):
        return f"ends with {done.returncode}", done.returncode
    if not all(re.fullmatch(r"homolog: [^\x00-\x1f\x7f]+", line) for line in said.splitlines()) or "mistake of the program" in said:
        return f"says {said[:200]!r}", done.returncode
    return "", "fenced" if "crashed" in said or "takes more than" in said else done.returncode


def write(folder, name, content):
    with open(os.path.join(folder, name), "wb") as file:
        file.write(content)


def sound_files(program, folder):
    """Contents by name, all of them in the folder, with the match of one of them with itself."""
    files = mesh_files.all_files() | stored_files.landmark_files()
    for name, content in (volume_files.beside() | files).items():
        write(folder, name, content)
    subprocess.run([program, "match", "solid.off", "solid.off", "--resolution", "48", "--out", "."], cwd=folder, check=True, capture_output=True)
    for name in ("match.json", "parts.json"):
        with open(os.path.join(folder, name), "rb") as file:
            files[name] = file.read()
    return files


def try_file(program, folder, name, content, options, limits):
    """How the runs ended, by number, and how many are broken."""
    dice, ends, broken = random.Random(f"{options.seed} {name}"), collections.Counter(), 0
    words = commands(name)
    for number in range(len(words) - 1 + options.files):
        is_sound = number < len(words)  # once with each command
        changed = content if is_sound else damaged_inside(name, content, dice)
        write(folder, name, changed)
        wrong, end = complaint([program, *words[number % len(words)]], folder, *limits)
        ends[end] += 1
        if is_sound and end != 0:
            wrong = wrong or "is not read although it is not damaged"
        if wrong:
            broken += 1
            print(f"{name}, seed {options.seed}, file {number}: {wrong}", flush=True)
            if options.keep:
                os.makedirs(options.keep, exist_ok=True)
                write(options.keep, f"{options.seed}-{number}-{name}", changed)
    write(folder, name, content)
    return ends, broken


def main():
    parser = argparse.ArgumentParser(description="Damaged files through the whole program.")
    parser.add_argument("program")
    parser.add_argument("--files", type=int, default=200, help="per format")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", help="one of the files")
    parser.add_argument("--keep", default=None, help="folder for the files that break something")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    slow = is_under_address_sanitizer(program)
    limits = (resource.RLIM_INFINITY, 5 * SECONDS) if slow else (MEMORY, SECONDS)
    broken = 0
    print(f"{'file':18} {'runs':>6} {'read':>6} {'refused':>8} {'fenced':>7} {'broken':>7}")
    with tempfile.TemporaryDirectory() as folder:
        for name, content in sound_files(program, folder).items():
            if options.only in (None, name):
                ends, bad = try_file(program, folder, name, content, options, limits)
                print(f"{name:18} {sum(ends.values()):6} {ends[0] + ends[1]:6} {ends[3]:8} {ends['fenced']:7} {bad:7}", flush=True)
                broken += bad
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
