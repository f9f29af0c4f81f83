// SPDX-License-Identifier: MIT
// From points with normals to little triangles that together wind around a place as the surface does [barill2018].
#pragma once

#include "homolog/shape/mesh.h"
#include "homolog/shape/point_cloud.h"

namespace homolog {

/// Fewer points, none nearer to another than about `cell` where their normals agree: the means of those in a cubic cell whose normals point
/// the same way along the same axis, with unit normals. Scans that overlap become one, noise less, and few points among many that look the
/// other way are left out.
PointCloud thinned(const PointCloud& cloud, double cell);

/// How much of the surface every point stands for: its Voronoi cell in its tangent plane among its nearest points, those that lie on the
/// other side of a sheet left out. Unit normals.
std::vector<double> point_areas(const PointCloud& cloud);

/// One equilateral triangle for every point, about it and of its area, the normal in front; triangle i has the vertices 3 i to 3 i + 2.
Mesh triangles_about(const PointCloud& cloud, const std::vector<double>& areas);

}  // namespace homolog
