# SPDX-License-Identifier: MIT
"""One method on one case: one_peer.py METHOD CASE prints {"matrix": 4 x 4} or {"points": [...], "places": [...]}, nothing if it found nothing."""
import json
import sys

import numpy as np

STEPS = np.arange(-6, 7) / 4  # of the sweep, in octaves: 13 scales
FEW = 1500  # points that the dense peers can carry


def clouds(case, rescale=1.0):
    import open3d as o3d
    o3d.utility.set_verbosity_level(o3d.utility.VerbosityLevel.Error)  # its warnings go to stdout
    result = []
    for key, factor in (("model_cloud", rescale), ("data_cloud", 1.0)):
        file = np.load(case[key])
        cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(factor * file["points"]))
        cloud.normals = o3d.utility.Vector3dVector(file["normals"])
        result.append(cloud)
    return result


def open3d_match(case, with_scaling, rescale=1.0, iterations=100000):
    """The matrix and what share of the model has a partner."""
    import open3d as o3d
    registration = o3d.pipelines.registration
    model, data = clouds(case, rescale)
    size = float(np.linalg.norm(np.ptp(np.asarray(data.points), axis=0)))
    voxel = 0.015 * size
    model, data = model.voxel_down_sample(voxel), data.voxel_down_sample(voxel)
    feature = [registration.compute_fpfh_feature(cloud, o3d.geometry.KDTreeSearchParamHybrid(0.075 * size, 200)) for cloud in (model, data)]
    found = registration.registration_ransac_based_on_feature_matching(
        model, data, *feature, True, 1.5 * voxel, registration.TransformationEstimationPointToPoint(with_scaling), 3,
        [registration.CorrespondenceCheckerBasedOnEdgeLength(0.9)] * (not with_scaling) +
        [registration.CorrespondenceCheckerBasedOnDistance(1.5 * voxel)],
        registration.RANSACConvergenceCriteria(iterations, 0.999))
    return found.transformation @ np.diag([rescale, rescale, rescale, 1]), found.fitness


def open3d_sweep(case):
    """The scale whose match covers the largest area of the data."""
    tries = []
    for step in STEPS:
        scale = 2.0 ** step
        matrix, fitness = open3d_match(case, False, scale, 20000)
        tries.append((fitness * scale * scale, matrix))
    return max(tries, key=lambda item: item[0])[1]


def few_points(case):
    """Both clouds as few points, shifted to their middles and scaled by one number."""
    random = np.random.default_rng(2)
    model, data = (np.load(case[key])["points"] for key in ("model_cloud", "data_cloud"))
    return [cloud[random.choice(len(cloud), FEW, replace=False)] for cloud in (model, data)]


def normalised(points):
    middle, size = points.mean(0), np.linalg.norm(points - points.mean(0), axis=1).mean()
    return (points - middle) / size, lambda x: x * size + middle


def pycpd_deformable(case):
    from pycpd import DeformableRegistration
    model, data = few_points(case)
    (y, _), (x, back) = normalised(model), normalised(data)
    places, _ = DeformableRegistration(X=x, Y=y, alpha=2, beta=2, max_iterations=100).register()
    return {"points": model.tolist(), "places": back(places).tolist()}


def probreg_bcpd(case):
    from probreg import bcpd
    model, data = few_points(case)
    (y, _), (x, back) = normalised(model), normalised(data)
    found = bcpd.registration_bcpd(y, x)
    return {"points": model.tolist(), "places": back(found.transform(y)).tolist()}


method, one = sys.argv[1], json.loads(sys.argv[2])
if method == "pycpd-deformable":
    print(json.dumps(pycpd_deformable(one)))
elif method == "probreg-bcpd":
    print(json.dumps(probreg_bcpd(one)))
else:
    matrix = open3d_sweep(one) if method == "open3d-sweep" else open3d_match(one, method.endswith("scaling"))[0]
    print(json.dumps({"matrix": np.asarray(matrix).tolist()}))
