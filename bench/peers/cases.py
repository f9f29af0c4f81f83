# SPDX-License-Identifier: MIT
"""Makes the cases in a folder and prints them as JSON: cases.py FOLDER MESHES POSES. Runs in the environment of the peers."""
import json
import os
import sys

import numpy as np
import open3d as o3d

PART = 0.45
SAMPLES = 20000


def load(path):
    mesh = o3d.io.read_triangle_mesh(path)
    mesh.remove_duplicated_vertices()
    return mesh


def diagonal(points):
    return float(np.linalg.norm(points.max(0) - points.min(0)))


def save_cloud(path, mesh, count, keep=None):
    o3d.utility.random.seed(7)
    mesh.compute_vertex_normals()
    cloud = mesh.sample_points_uniformly(count, use_triangle_normal=True)
    points, normals = np.asarray(cloud.points), np.asarray(cloud.normals)
    if keep is not None:
        points, normals = points[keep(points)], normals[keep(points)]
    np.savez(path, points=points, normals=normals)
    np.savetxt(path + ".txt", np.hstack([points, normals]))


def rigid_cases(path, folder, random):
    mesh, name = load(path), os.path.splitext(os.path.basename(path))[0]
    vertices = np.asarray(mesh.vertices).copy()
    low, extent = vertices.min(0), np.ptp(vertices, 0)
    axis = int(extent.argmax())

    def lower(points):
        return points[:, axis] < low[axis] + PART * extent[axis]

    for scale in (1.0, 1.7):
        rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
        rotation *= np.sign(np.linalg.det(rotation))
        turned = scale * vertices @ rotation.T + diagonal(vertices) * random.normal(size=3)
        data = os.path.join(folder, f"{name}_{scale}.off")
        moved = o3d.geometry.TriangleMesh(o3d.utility.Vector3dVector(turned), mesh.triangles)
        o3d.io.write_triangle_mesh(data, moved)
        save_cloud(data + ".npz", moved, SAMPLES)
        for part in (False, True):
            stem = os.path.join(folder, f"{name}_{scale}_{part}")
            save_cloud(stem + ".npz", mesh, SAMPLES, lower if part else None)
            kept = lower(vertices) if part else np.ones(len(vertices), bool)
            np.savez(stem + "_truth.npz", points=vertices[kept], places=turned[kept], diagonal=diagonal(turned))
            yield {"kind": "rigid", "name": f"{name}, {'part' if part else 'whole'}, turned, x {scale}", "model": path, "data": data,
                   "part": f"{'xyz'[axis]}<{PART}" if part else "", "model_cloud": stem + ".npz", "data_cloud": data + ".npz",
                   "truth": stem + "_truth.npz"}


def pose_case(model, data, folder):
    a, b = o3d.io.read_triangle_mesh(model), o3d.io.read_triangle_mesh(data)
    stem = os.path.join(folder, os.path.basename(model) + os.path.basename(data))
    save_cloud(stem + "_model.npz", a, SAMPLES)
    save_cloud(stem + "_data.npz", b, SAMPLES)
    np.savez(stem + "_truth.npz", points=np.asarray(a.vertices), places=np.asarray(b.vertices), diagonal=diagonal(np.asarray(b.vertices)))
    name = f"{os.path.splitext(os.path.basename(model))[0]} -> {os.path.splitext(os.path.basename(data))[0]}, another pose"
    return {"kind": "poses", "name": name, "model": model, "data": data, "model_cloud": stem + "_model.npz",
            "data_cloud": stem + "_data.npz", "truth": stem + "_truth.npz"}


folder, meshes, poses = sys.argv[1], json.loads(sys.argv[2]), json.loads(sys.argv[3])
generator = np.random.default_rng(1)
cases = [case for mesh in meshes for case in rigid_cases(mesh, folder, generator)]
print(json.dumps(cases + [pose_case(model, data, folder) for model, data in poses]))
