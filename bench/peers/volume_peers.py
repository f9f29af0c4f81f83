# SPDX-License-Identifier: MIT
"""Peers on volumes of N^3 made here: volume_peers.py METHOD N, METHOD one of scipy-pyramid, itk-pyramid, skimage-blob-dog.

blob-dog looks for balls and prints [[x, y, z], ...]; volume_peers.py balls N FILE writes the same balls as a mesh, for homolog (ball N FILE
one that fills the volume, for beside the pyramids), and
volume_peers.py judge N FILE says how many of them an answer found, that of blob-dog or homolog's points.json."""
import json
import sys

import numpy as np

SMALLEST, LARGEST = 0.03, 0.1  # radii of balls, in sides of the volume


def balls(grid):
    """Centres and radii of 27 balls of all sizes in voxels, each in its cell of a lattice."""
    random = np.random.default_rng(3)
    cells = np.stack(np.meshgrid(*[np.arange(3)] * 3, indexing="ij"), -1).reshape(-1, 3)
    radii = SMALLEST * (LARGEST / SMALLEST) ** random.permutation(np.linspace(0, 1, len(cells)))
    shifts = random.uniform(-1, 1, (len(cells), 3)) * (1 / 6 - 0.02 - radii)[:, None]
    return grid * ((cells + 0.5) / 3 + shifts), grid * radii


def ball_volume(grid):
    volume = np.zeros((grid,) * 3, np.float32)
    for centre, radius in zip(*balls(grid)):
        low, high = np.floor(centre - radius - 2).clip(0).astype(int), np.ceil(centre + radius + 3).clip(0, grid).astype(int)
        there = tuple(slice(*ends) for ends in zip(low, high))
        x, y, z = np.ogrid[there]
        distance = np.sqrt((x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2)
        volume[there] = np.clip(radius - distance + 0.5, 0, 1)
    return volume


def ball_mesh(placed, path, rings=24):
    """As OFF: balls by their centres and radii, of `rings` circles of latitude."""
    vertices, triangles = [], []
    theta, phi = np.pi * np.arange(1, rings) / rings, 2 * np.pi * np.arange(2 * rings) / (2 * rings)
    sphere = [(0, 0, 1)] + [(np.sin(t) * np.cos(p), np.sin(t) * np.sin(p), np.cos(t)) for t in theta for p in phi] + [(0, 0, -1)]
    row, last = 2 * rings, len(sphere) - 1
    faces = [(0, 1 + j, 1 + (j + 1) % row) for j in range(row)]
    for i in range(rings - 2):
        for j in range(row):
            a, b = 1 + i * row + j, 1 + i * row + (j + 1) % row
            faces += [(a, a + row, b + row), (a, b + row, b)]
    faces += [(last, last - row + (j + 1) % row, last - row + j) for j in range(row)]
    for centre, radius in placed:
        triangles += [tuple(len(vertices) + corner for corner in face) for face in faces]
        vertices += [centre + radius * np.array(v) for v in sphere]
    with open(path, "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(triangles)} 0\n")
        file.writelines("%.9g %.9g %.9g\n" % tuple(v) for v in vertices)
        file.writelines("3 %d %d %d\n" % t for t in triangles)


def blob_dog(grid):
    from skimage.feature import blob_dog
    sigma = grid / 3 ** 0.5  # of a ball as large as the volume: a ball answers most at r / sqrt 3
    found = blob_dog(ball_volume(grid), min_sigma=0.8 * SMALLEST * sigma, max_sigma=1.3 * LARGEST * sigma, sigma_ratio=2 ** (1 / 3), threshold=0.1)
    return found[:, :3].tolist()


def judge(grid, path):
    """A ball is found by a point within half its radius of its centre."""
    answer = json.load(open(path))
    points = np.array([point["position"] for point in answer["shape"]["points"]] if isinstance(answer, dict) else answer).reshape(-1, 3)
    centres, radii = balls(grid)
    near = np.linalg.norm(points[:, None] - centres[None], axis=2) < 0.5 * radii
    return f"{near.any(0).sum()} of {len(centres)} balls found, {(~near.any(1)).sum()} points elsewhere"


def pyramid(grid, blur):
    """4 octaves of 5 Gaussians, each from the octave's first level; differences, no search for minima."""
    volume = np.zeros((grid,) * 3, np.float32)
    volume[grid // 4:3 * grid // 4, grid // 4:3 * grid // 4, grid // 4:3 * grid // 4] = 1
    for _ in range(4):
        levels = [volume]
        for level in range(1, 5):
            before, now = 1.6 * 2 ** ((level - 1) / 2), 1.6 * 2 ** (level / 2)
            levels.append(blur(levels[-1], (now * now - before * before) ** 0.5))
            levels[-2] = levels[-1] - levels[-2]
        volume = np.ascontiguousarray(levels[-1][::2, ::2, ::2])


def scipy_blur(volume, sigma):
    from scipy.ndimage import gaussian_filter
    return gaussian_filter(volume, sigma)


def itk_blur(volume, sigma):
    import itk
    image = itk.image_view_from_array(volume)
    return itk.array_from_image(itk.smoothing_recursive_gaussian_image_filter(image, sigma=sigma))


method, side = sys.argv[1], int(sys.argv[2])
if method == "balls":
    ball_mesh(zip(*balls(side)), sys.argv[3])
elif method == "ball":
    ball_mesh([(np.full(3, side / 2), side / 2)], sys.argv[3], 200)
elif method == "judge":
    print(judge(side, sys.argv[3]))
elif method == "skimage-blob-dog":
    print(json.dumps(blob_dog(side)))
else:
    pyramid(side, scipy_blur if method == "scipy-pyramid" else itk_blur)
