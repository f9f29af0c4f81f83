// SPDX-License-Identifier: MIT
// Normals of a point cloud that look the other way than all around them: estimated normals have a few per cent of them turned over.
#pragma once

#include "homolog/shape/point_cloud.h"

namespace homolog {

inline constexpr std::size_t overruled_by = 5;  ///< times as many points that look the other way turn or drop one that lies among them

/// Turns over, in three rounds, every normal that is overruled by the 24 points nearest to it: those within 60 degrees of it against those
/// within 60 degrees of its opposite. Where two sheets lie closer than the points, both sides are there, and normals stay. Unit normals.
/// Independent of threads.
void turn_overruled(PointCloud& cloud);

}  // namespace homolog
