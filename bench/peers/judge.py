# SPDX-License-Identifier: MIT
"""How right an answer is: judge.py CASE ANSWER prints a verdict. The answer is a peer's (see one_peer.py) or homolog's match.json."""
import json
import sys

import numpy as np


def spline(warp, points):
    """x -> A x + t + sum of w phi(|x - c|), as match.json tells it."""
    centres, weights, affine = (np.array(warp[key]) for key in ("centres", "weights", "affine"))
    places = points @ affine[:, :3].T + affine[:, 3]
    if len(centres) == 0:
        return places
    for chunk in np.array_split(np.arange(len(points)), max(1, len(points) // 1000)):
        distance = np.linalg.norm(points[chunk, None] - centres[None], axis=2)
        places[chunk] += (distance if warp["kernel"] == "r" else distance ** 3) @ weights
    return places


def nearest_offset(answer, points):
    """A map known at some points, carried to others by the nearest ones."""
    from scipy.spatial import cKDTree
    known, places = np.array(answer["points"]), np.array(answer["places"])
    distance, nearest = cKDTree(known).query(points, k=4)
    weight = 1 / np.maximum(distance, 1e-12)
    return (places[nearest] * (weight / weight.sum(1, keepdims=True))[..., None]).sum(1)


def mapped(answer, points):
    if "matrix" in answer:
        matrix = np.array(answer["matrix"])
        return points @ matrix[:3, :3].T + matrix[:3, 3]
    if "places" in answer:
        return nearest_offset(answer, points)
    if answer.get("matches"):
        return spline(answer["matches"][0]["warp"], points)
    return None


case, answer = json.loads(sys.argv[1]), json.load(open(sys.argv[2]))
truth = np.load(case["truth"])
places = mapped(answer, truth["points"])
if places is None:
    print("found nothing")
else:
    error = np.linalg.norm(places - truth["places"], axis=1) / truth["diagonal"]
    rms = float(np.sqrt((error ** 2).mean()))
    share = float((error < 0.05).mean())
    print(f"{'right' if rms < 0.05 else 'wrong'} (rms {rms:.3f}, share {share:.2f})")
