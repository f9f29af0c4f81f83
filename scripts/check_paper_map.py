#!/usr/bin/env python3
"""Every file, function and test that docs/paper_map.md names is there."""
import os
import re
import sys


def complaints(line):
    for path, functions in re.findall(r"`([a-z_/]+\.(?:cpp|h))(?:: ([^`]*))?`", line):
        file = "src/homolog/" + path
        if not os.path.exists(file):
            yield f"there is no {file}"
            continue
        text = open(file, encoding="utf-8").read()
        yield from (f"{path} has no '{name}'" for name in re.findall(r"\w+", functions) if not re.search(rf"\b{name}\b", text))
    for test in re.findall(r"`([a-z_/]+_test)`", line):
        if not os.path.exists(f"tests/{test}.cpp"):
            yield f"there is no tests/{test}.cpp"


bad = 0
for number, line in enumerate(open("docs/paper_map.md", encoding="utf-8"), 1):
    for problem in complaints(line):
        print(f"docs/paper_map.md:{number}: {problem}")
        bad += 1
sys.exit(1 if bad else 0)
