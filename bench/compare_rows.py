#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What differs between two runs of bench_accuracy on the same pairs: how many have the same outcome, the same number of pairs told, the
same numbers of right and judged ones, and the very same pairs told.

usage: compare_rows.py ROWS ROWS   (what bench_accuracy wrote with --rows)
"""
import csv
import sys

SAME = {"outcome": ["outcome"], "number of pairs told": ["pairs"], "right and judged pairs": ["right", "judged"], "pairs told": ["told"]}


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return {(row["task"], row["model"], row["data"]): row for row in csv.DictReader(file, delimiter="\t")}


def main(first_path, second_path):
    first, second = rows_of(first_path), rows_of(second_path)
    both = [key for key in first if key in second]
    for name, columns in SAME.items():
        if any(column not in row for column in columns for rows in (first, second) for row in rows.values()):
            continue  # written before the column was
        same = sum(all(first[key][column] == second[key][column] for column in columns) for key in both)
        print(f"same {name}: {same} of {len(both)}")
    for key in both:
        if first[key]["outcome"] != second[key]["outcome"]:
            print(f"  {' '.join(key)}: {first[key]['outcome']}, then {second[key]['outcome']}")
    if len(both) < max(len(first), len(second)):
        print(f"not in both: {len(first) + len(second) - 2 * len(both)}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
