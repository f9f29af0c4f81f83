#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Other pairs of the same shapes: a list to check choices on that were made on the first one.

usage: more_pairs.py FOLDER OUT

FOLDER holds pairs.tsv, its shapes and their truth. OUT becomes a folder that links to them, with 300 pairs (always the same ones) of
which none is in FOLDER's list, and 150 pairs of shapes that share nothing, for bench_accuracy OUT.
"""
import os
import random
import sys

LANDMARKS = "clicked landmarks, same name = same point (left/right swap allowed)"
VERTICES = "identity (vertex i <-> i)"
WHOLES = [  # set, pairs, truth
    ("animals_clicked", 80, LANDMARKS),
    ("bipeds_clicked", 60, LANDMARKS),
    ("humans_makehuman", 25, VERTICES),
    ("hand_webxr", 14, VERTICES),
    ("animals_0ad", 6, VERTICES),
]
MOST_PARTS, MOST_OF_ONE_PART = 120, 3
FOREIGN = ["hand_webxr", "animals_clicked", "humans_makehuman", "biplanes_flightgear", "primate_hemispheres"]  # but animals and people: both have four limbs
STRANGERS = 150


def shapes_of(folder, name):
    files = sorted(os.listdir(os.path.join(folder, name)))
    return [f[:-4] for f in files if f.endswith(".off") and not f.endswith(".soup.off")]


def has_truth(name, model, data):
    """Whether vertices or landmarks correspond, and the first list does not hold the pair's kind many times."""
    if name == "animals_0ad":
        return model.split("_")[0] == data.split("_")[0] and "celtic" not in model + data
    if name == "hand_webxr":
        return ("left" in model) == ("left" in data)
    if name == "bipeds_clicked":  # people against each other are in humans_makehuman
        return not (is_posed_human(model) and is_posed_human(data))
    return True


def is_posed_human(shape):
    return "_" in shape and shape.split("_")[0] in ("man", "woman", "baby", "thinman", "heavyman", "oldman", "heavywoman")


def wholes(folder, listed):
    rows = []
    for name, most, truth in WHOLES:
        shapes = shapes_of(folder, name)
        pairs = [(f"{name}/{a}", f"{name}/{b}") for a in shapes for b in shapes if a != b and has_truth(name, a, b)]
        pairs = [pair for pair in pairs if pair not in listed]
        random.shuffle(pairs)
        rows += [("whole", *pair, truth) for pair in pairs[:most]]
    return rows


def parts(folder, listed, first_rows):
    known = {}  # (part, set of the data): truth
    for task, model, data, truth, *_ in first_rows:
        if task == "part" and model.startswith("parts_cut"):
            known[model, data.split("/")[0]] = truth
    candidates = []
    for (model, name), truth in known.items():
        source = model.split("/")[1].split("__")[0]
        for shape in shapes_of(folder, name):
            if (model, f"{name}/{shape}") not in listed and (name in ("humans_makehuman", "bipeds_clicked", "animals_clicked") or has_truth(name, source, shape)):
                candidates.append(("part", model, f"{name}/{shape}", truth))
    random.shuffle(candidates)
    rows, count = [], {}
    for row in candidates:
        if count.get(row[1], 0) < MOST_OF_ONE_PART and len(rows) < MOST_PARTS:
            count[row[1]] = count.get(row[1], 0) + 1
            rows.append(row)
    return rows


def strangers(folder):
    sets = [(a, b) for a in FOREIGN for b in FOREIGN if a != b and {a, b} != {"animals_clicked", "humans_makehuman"}]
    pairs = [(f"{a}/{model}", f"{b}/{data}") for a, b in sets for model in shapes_of(folder, a) for data in shapes_of(folder, b)]
    wholes = [pair for pair in pairs if "__" not in pair[0] + pair[1]]
    return [("unrelated", *pair, "share nothing") for pair in random.Random(6).sample(sorted(wholes), STRANGERS)]


def main(folder, out):
    random.seed(5)
    with open(os.path.join(folder, "pairs.tsv"), encoding="utf-8") as file:
        header, *lines = file.read().splitlines()
    first_rows = [line.split("\t") for line in lines]
    listed = {(row[1], row[2]) for row in first_rows}
    os.makedirs(out, exist_ok=True)
    for name in sorted(os.listdir(folder)):
        link = os.path.join(out, name)
        if name != "pairs.tsv" and not os.path.lexists(link):
            os.symlink(os.path.join(os.path.abspath(folder), name), link)
    rows = wholes(folder, listed) + parts(folder, listed, first_rows) + strangers(folder)
    with open(os.path.join(out, "pairs.tsv"), "w", encoding="utf-8") as file:
        file.write("\n".join([header] + ["\t".join((*row, "-", "")) for row in rows]) + "\n")
    print(f"{len(rows)} pairs in {out}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
