#!/usr/bin/env python3
"""Nobody includes upward: each room of src/homolog may look into itself and the rooms before it, programs only at the library."""
import re
import subprocess
import sys

ROOMS = ["base", "shape", "salient", "describe", "match", "homolog.h", "outputs"]
ABOVE = ("cli", "bench", "examples", "tests", "python")
NO_SHAPES = ("cliques", "thin_plate_spline")  # of match/: pure graph and spline code, may look into base alone
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]')


def room(path):
    """base for homolog/base/vec.h, homolog.h for homolog/homolog.h and its .cpp, None for what is not the library's."""
    parts = path.split("/")
    if parts[0] != "homolog":
        return None
    return parts[1] if len(parts) > 2 else "homolog.h"


def complaint(file, target):
    if file.startswith(ABOVE):
        own = target.split("/")[0] in ABOVE
        return f"reaches into another program by {target}" if own and not file.startswith(target.split("/")[0]) else None
    if target.split("/")[0] in ABOVE:
        return f"the library includes {target}"
    here, there = room(file.removeprefix("src/")), room(target)
    if there is None:
        return None
    if there not in ROOMS or here not in ROOMS:
        return f"'{here if here not in ROOMS else there}' is no room of the library (see ROOMS in this check)"
    if ROOMS.index(there) > ROOMS.index(here):
        return f"{here} includes upward: {target}"
    stem = file.rsplit("/", 1)[-1].split(".")[0]
    if here == "match" and stem in NO_SHAPES and there != "base" and not target.startswith(f"homolog/match/{stem}."):
        return f"{stem} knows nothing of shapes, but includes {target}"
    return None


files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "*.h", "*.cpp"], check=True, capture_output=True, text=True)
bad = 0
for file in files.stdout.split():
    if not file.startswith(("src/homolog/", *ABOVE)):
        continue
    for number, line in enumerate(open(file, encoding="utf-8"), 1):
        include = INCLUDE.match(line)
        problem = include and complaint(file, include.group(1))
        if problem:
            print(f"{file}:{number}: {problem}")
            bad += 1
sys.exit(1 if bad else 0)
