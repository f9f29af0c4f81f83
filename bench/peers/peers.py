#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What one would take instead of homolog, on the same shapes in the same run: CPU time, memory, and who was right.

bench/peers/peers.py PROGRAM MESH... [--poses MODEL DATA] [--venv DIR]     PROGRAM is the built homolog

The peers come by pip into a virtual environment (build/peers; made at the first run); what cannot be installed is told and left out. Every
case is one process per method, all methods one after the other and that three times (--repeats); the least CPU time is told, and the largest
peak. Shapes: the model against itself turned at random, times 1 and 1.7, whole or the lower 45 % of its longest side alone; and with --poses,
two meshes whose vertices correspond by number. Rigid peers get 20 000 points of the whole with exact normals and the part's points without
a cap. right: the vertices of the model land within 5 % of the data's diagonal of their true places, root mean square. share: of vertices
within 5 %. Volumes (--grids): the blur of a scale space alone, beside all that `homolog points` does for a ball that fills as large a volume; and
points at 27 balls of all sizes. homolog gets balls as meshes.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGES = ["numpy", "scipy", "scikit-image", "open3d", "itk-filtering", "pycpd", "probreg"]
PCL = ["pcl_features", "pcl_filters", "pcl_kdtree", "pcl_recognition"]  # by Debian: libpcl-dev
RIGID = ["homolog", "pcl-shot-gc", "open3d-ransac", "open3d-ransac-scaling", "open3d-sweep"]
DENSE = ["homolog", "open3d-ransac", "pycpd-deformable", "probreg-bcpd"]
PYRAMIDS = ["homolog", "scipy-pyramid", "itk-pyramid"]
POINTS = ["homolog", "skimage-blob-dog"]
PACKAGE_OF = {"pcl": "libpcl-dev", "open3d": "open3d", "pycpd": "pycpd", "probreg": "probreg", "scipy": "scipy", "itk": "itk-filtering",
              "skimage": "scikit-image"}  # by the first word of a method
BYTES_PER_VOXEL = {"scipy-pyramid": 42, "itk-pyramid": 42, "skimage-blob-dog": 100}  # at their peak, about


def environment(folder):
    """The Python of a virtual environment with the peers, and what could not be installed."""
    python = os.path.join(folder, "bin", "python")
    if not os.path.exists(python):
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    missing = []
    for package in PACKAGES:
        if subprocess.run([python, "-m", "pip", "show", "-q", package], stderr=subprocess.DEVNULL).returncode != 0:
            if subprocess.run([python, "-m", "pip", "install", "-q", package], stderr=subprocess.DEVNULL).returncode != 0:
                missing.append(package)
    return python, missing


def built_pcl(folder):
    """The program of pcl_shot.cpp, or None where PCL is not installed."""
    source, program = os.path.join(HERE, "pcl_shot.cpp"), os.path.join(folder, "pcl_shot")
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", *PCL], capture_output=True, text=True)
    if flags.returncode != 0:
        return None
    words = ["g++", "-O2", "-std=c++17", "-w", source, "-o", program, *flags.stdout.split()]
    built = os.path.exists(program) and os.path.getmtime(program) > os.path.getmtime(source)
    return program if built or subprocess.run(words).returncode == 0 else None


def timed(words, limit):
    """Runs a process; returns what it printed, CPU seconds, peak MiB, or None when it failed or took longer than the limit."""
    with tempfile.TemporaryFile("w+") as out:
        child = subprocess.Popen(words, stdout=out, stderr=subprocess.DEVNULL,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        text = out.read()
        answered = child.returncode == 0 or (child.returncode == 1 and text.startswith("{"))  # homolog's 1: nothing found
        return text if answered else None, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def run_in_turns(name, commands, judge, options):
    """A row for each method: the least CPU time and the largest peak of all turns, and the verdict of the last."""
    rows = {method: [float("inf"), 0, ""] for method in commands}
    waiting = dict(commands)
    for _ in range(options.repeats):
        for method, words in list(waiting.items()):
            text, seconds, mib = timed(words, options.limit)
            cpu, peak, _ = rows[method]
            rows[method] = [min(cpu, seconds), max(peak, mib), f"failed, or took {options.limit} s" if text is None else judge(text)]
            if text is None or seconds > options.limit / 4:  # once is enough
                del waiting[method]
    for method, (cpu, peak, verdict) in rows.items():
        print(f"{name:44} {method:24} {cpu:8.2f} {peak:9.0f}  {verdict}", flush=True)


def judged(words, text, folder):
    """What a judging program says of an answer; it gets the answer's file as its last word."""
    answer = os.path.join(folder, "answer.json")
    with open(answer, "w") as file:
        file.write(text or "{}")
    return subprocess.run([*words, answer], capture_output=True, text=True).stdout.strip() or "failed"


def run_shapes(python, pcl, installed, folder, options):
    made = subprocess.run([python, os.path.join(HERE, "cases.py"), folder, json.dumps(options.meshes), json.dumps(options.poses)],
                          check=True, capture_output=True, text=True).stdout
    for case in json.loads(made):
        part = ["--model-part", case["part"]] if case.get("part") else []
        commands = {}
        for method in filter(installed, DENSE if case["kind"] == "poses" else RIGID):
            commands[method] = [python, os.path.join(HERE, "one_peer.py"), method, json.dumps(case)]
        commands["homolog"] = [options.program, "match", case["model"], case["data"], "--json", "--quiet", "--threads", "1", *part]
        if "pcl-shot-gc" in commands:
            commands["pcl-shot-gc"] = [pcl, case["model_cloud"] + ".txt", case["data_cloud"] + ".txt"]
        judge = [python, os.path.join(HERE, "judge.py"), json.dumps(case)]
        run_in_turns(case["name"], commands, lambda text: judged(judge, text, folder), options)


def free_bytes():
    with open("/proc/meminfo") as file:
        return 1024 * next(int(line.split()[1]) for line in file if line.startswith("MemAvailable"))


def run_volumes(python, installed, grid, folder, options):
    def fits(name, method):
        needed, free = BYTES_PER_VOXEL.get(method, 0) * grid ** 3, free_bytes()
        if needed > free:
            print(f"{name:44} {method:24} left out: it takes about {needed / 2**30:.0f} GiB, and {free / 2**30:.0f} are free", flush=True)
        return needed <= free

    program = os.path.join(HERE, "volume_peers.py")
    judge = [python, program, "judge", str(grid)]

    def run(name, methods, mesh, verdict):
        commands = {method: [python, program, method, str(grid)] for method in methods if installed(method) and fits(name, method)}
        file = os.path.join(folder, mesh + ".off")
        subprocess.run([python, program, mesh, str(grid), file], check=True)
        commands["homolog"] = [options.program, "points", file, "--resolution", str(grid), "--json", "--quiet", "--threads", "1"]
        run_in_turns(name, commands, verdict, options)

    run(f"pyramid {grid}^3, 4 octaves of 5 Gaussians", PYRAMIDS, "ball",
        lambda text: "read, voxels, pyramid, minima, descriptors" if text.startswith("{") else "blurs alone")
    run(f"27 balls in {grid}^3, their points", POINTS, "balls", lambda text: judged(judge, text, folder))


def parsed_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("meshes", nargs="*")
    parser.add_argument("--poses", nargs=2, action="append", default=[], metavar=("MODEL", "DATA"))
    parser.add_argument("--grids", default="128,256,512", help="sides of the volumes; empty for none")
    parser.add_argument("--venv", default="build/peers")
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--limit", type=int, default=180, help="CPU seconds a process may take")
    return parser.parse_args()


def main():
    options = parsed_options()
    python, missing = environment(options.venv)
    pcl = built_pcl(options.venv)
    missing += [] if pcl else ["libpcl-dev"]
    print("not installed:", ", ".join(missing) or "nothing")
    print("not to be had by apt or pip: SIFT3D (scikit-image's blob_dog stands for it), TEASER++, BCPD's own program (probreg's stands for it)")
    print(f"{'case':44} {'method':24} {'CPU s':>8} {'peak MiB':>9}  verdict", flush=True)

    def installed(method):
        return PACKAGE_OF.get(method.split("-")[0]) not in missing

    os.environ.update({name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS")})
    with tempfile.TemporaryDirectory() as folder:
        if "numpy" in missing:
            print("nothing can be run without numpy")
            return
        if "open3d" in missing or "scipy" in missing:
            print("no shapes are run: the cases are made by open3d and judged by scipy")
        else:
            run_shapes(python, pcl, installed, folder, options)
        for grid in [int(word) for word in options.grids.split(",") if word]:
            run_volumes(python, installed, grid, folder, options)


if __name__ == "__main__":
    start = time.time()
    main()
    print(f"{time.time() - start:.0f} s")
