#!/usr/bin/env python3
"""Every command shown in a code block of the docs exists: homolog's verbs and options, scripts, CMake presets."""
import json
import os
import re
import shlex
import subprocess
import sys

PROGRAM = sys.argv[1]


def listed(pattern):
    return subprocess.run(["git", "ls-files", "-co", "--exclude-standard", pattern], check=True, capture_output=True, text=True).stdout.split()


def commands(text):
    """Lines of the ``` blocks, continuation lines joined, a leading prompt taken off."""
    for block in re.findall(r"^```[^\n]*\n(.*?)^```", text, re.S | re.M):
        for line in block.replace("\\\n", " ").split("\n"):
            yield line.strip().removeprefix("$ ")


def help_of(words):
    run = subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True)
    return run.stdout if run.returncode == 0 else None


def homolog_complaint(words):
    verb = [words[1]] if len(words) > 1 and not words[1].startswith("-") else []
    text = help_of(verb)
    if text is None:
        return f"homolog has no '{' '.join(verb)}'"
    unknown = [w for w in words[1:] if w.startswith("-") and not re.search(rf"(^|[\s,]){re.escape(w.split('=')[0])}\b", text)]
    return f"no option {', '.join(unknown)}" if unknown else None


def complaint(line):
    if not re.match(r"(\S*/)?homolog\s|scripts/|cmake --|ctest --", line):
        return None
    words = []
    for word in shlex.split(line, comments=True):
        if word in ("&&", "|", ">", ";"):
            break
        words.append(word)
    if re.fullmatch(r"(\S*/)?homolog", words[0]):
        return homolog_complaint(words)
    if words[0].startswith("scripts/"):
        return None if os.access(words[0], os.X_OK) else f"{words[0]} is not there or cannot be run"
    presets = [p["name"] for p in json.load(open("CMakePresets.json", encoding="utf-8"))["configurePresets"]]
    named = words[words.index("--preset") + 1] if "--preset" in words else presets[0]
    return None if named in presets else f"no preset '{named}'"


bad = 0
for path in listed("*.md"):
    for line in commands(open(path, encoding="utf-8").read()):
        problem = complaint(line)
        if problem:
            print(f"{path}: '{line}': {problem}")
            bad += 1
sys.exit(1 if bad else 0)
