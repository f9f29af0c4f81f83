#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What one would take instead of homolog, on the same shapes in the same run: CPU time, memory, and who was right.

bench/peers/peers.py PROGRAM MESH... [--poses MODEL DATA] [--venv DIR]     PROGRAM is the built homolog

The peers come by pip into a virtual environment (build/peers; made at the first run). Every case is one process per method: the model
against itself turned at random, times 1 and 1.7, whole or the lower 45 % of its longest side alone; and with --poses, two meshes whose vertices
correspond by number. Rigid peers get 20 000 points of the whole with exact normals and the part's points without a cap.
right: the vertices of the model land within 5 % of the data's diagonal of their true places, root mean square. share: of vertices within 5 %.
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
PACKAGES = ["numpy", "scipy", "open3d", "itk-filtering", "pycpd", "probreg"]
PCL = ["pcl_features", "pcl_filters", "pcl_kdtree", "pcl_recognition"]  # by Debian: libpcl-dev
RIGID = ["homolog", "pcl-shot-gc", "open3d-ransac", "open3d-ransac-scaling", "open3d-sweep"]
DENSE = ["homolog", "open3d-ransac", "pycpd-deformable", "probreg-bcpd"]
PYRAMIDS = ["scipy-pyramid", "itk-pyramid"]


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
    program = os.path.join(folder, "pcl_shot")
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", *PCL], capture_output=True, text=True)
    if flags.returncode != 0:
        return None
    words = ["g++", "-O2", "-std=c++17", "-w", os.path.join(HERE, "pcl_shot.cpp"), "-o", program, *flags.stdout.split()]
    return program if os.path.exists(program) or subprocess.run(words).returncode == 0 else None


def timed(words, limit):
    """Runs a process; returns what it printed, CPU seconds, peak MiB, or None when it failed or took longer than the limit."""
    with tempfile.TemporaryFile("w+") as out:
        child = subprocess.Popen(words, stdout=out, stderr=subprocess.DEVNULL,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        return out.read() if child.returncode in (0, 1) else None, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def run_case(python, program, pcl, method, case, folder, repeats, limit):
    """The least CPU time of some runs, and the verdict of the last."""
    cpu, peak, verdict = float("inf"), 0, "failed"
    for _ in range(repeats):
        if method == "homolog":
            part = ["--model-part", case["part"]] if case.get("part") else []
            words = [program, "match", case["model"], case["data"], "--json", "--quiet", "--threads", "1", *part]
        elif method == "pcl-shot-gc":
            words = [pcl, case["model_cloud"] + ".txt", case["data_cloud"] + ".txt"]
        else:
            words = [python, os.path.join(HERE, "one_peer.py"), method, json.dumps(case)]
        text, seconds, mib = timed(words, limit)
        cpu, peak = min(cpu, seconds), max(peak, mib)
        if text is None:
            break
        answer = os.path.join(folder, "answer.json")
        with open(answer, "w") as file:
            file.write(text or "{}")
        judged = subprocess.run([python, os.path.join(HERE, "judge.py"), json.dumps(case), answer], capture_output=True, text=True)
        verdict = judged.stdout.strip() or "failed"
        if seconds > limit / 4:
            break
    return cpu, peak, verdict


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("meshes", nargs="+")
    parser.add_argument("--poses", nargs=2, action="append", default=[], metavar=("MODEL", "DATA"))
    parser.add_argument("--venv", default="build/peers")
    parser.add_argument("--repeats", type=int, default=1)
    parser.add_argument("--limit", type=int, default=180, help="CPU seconds a process may take")
    options = parser.parse_args()
    python, missing = environment(options.venv)
    pcl = built_pcl(options.venv)
    print("not installed:", ", ".join(missing + ([] if pcl else ["libpcl-dev (by apt)"])) or "nothing")
    print("not to be had by apt or pip: SIFT3D, TEASER++, BCPD's own program (probreg's stands for it)")
    print(f"{'case':44} {'method':24} {'CPU s':>8} {'peak MiB':>9}  verdict", flush=True)
    threads = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "ITK_GLOBAL_DEFAULT_NUMBER_OF_THREADS")}
    os.environ.update(threads)
    with tempfile.TemporaryDirectory() as folder:
        cases = json.loads(subprocess.run([python, os.path.join(HERE, "cases.py"), folder, json.dumps(options.meshes), json.dumps(options.poses)],
                                          check=True, capture_output=True, text=True).stdout)
        for case in cases:
            for method in DENSE if case["kind"] == "poses" else RIGID:
                if method == "pcl-shot-gc" and not pcl:
                    continue
                cpu, peak, verdict = run_case(python, options.program, pcl, method, case, folder, options.repeats, options.limit)
                print(f"{case['name']:44} {method:24} {cpu:8.2f} {peak:9.0f}  {verdict}", flush=True)
    for grid in (128, 256):
        for method in PYRAMIDS:
            text, cpu, peak = timed([python, os.path.join(HERE, "one_peer.py"), method, str(grid)], options.limit)
            print(f"{f'pyramid {grid}^3, 4 octaves of 5 Gaussians':44} {method:24} {cpu:8.2f} {peak:9.0f}  {'' if text is not None else 'failed'}")


if __name__ == "__main__":
    start = time.time()
    main()
    print(f"{time.time() - start:.0f} s")
