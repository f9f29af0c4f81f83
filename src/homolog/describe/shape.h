// SPDX-License-Identifier: MIT
// Sec. 3: all that is known of one shape once it is described; matching needs nothing else.
#pragma once

#include <string>
#include <vector>

#include "homolog/describe/body.h"
#include "homolog/describe/descriptors.h"
#include "homolog/describe/ends.h"
#include "homolog/describe/sample_blocks.h"
#include "homolog/salient/salient_point.h"
#include "homolog/shape/volume.h"

namespace homolog {

struct Shape {
  std::string name;     ///< how outputs call it: the file's name without its folder
  bool ras = false;     ///< Mesh::ras
  double diagonal = 0;  ///< of the bounding box of the part in use, in the file's units
  Interior interior;
  double guessed = 0;                  ///< share of the volume that the voxeliser had to guess (open meshes), 0 to 1
  double open = 0;                     ///< share of the triangles' sides without a neighbour, 0 to 1
  std::size_t components = 1;          ///< pieces of the mesh's surface
  std::vector<SalientPoint> points;    ///< X, largest radius first
  Descriptors descriptors;             ///< mu, parallel to points
  std::vector<SurfaceSample> surface;  ///< even samples in farthest-point order
  SampleBlocks surface_blocks;         ///< of these samples
  double surface_spacing = 0;          ///< typical distance of neighbouring samples
  std::vector<double> thickness;       ///< of the solid under each sample
  Body body;                           ///< joins the first of these samples and the points inside the solid
  Ends ends;                           ///< of the body
  Eigen::MatrixXd inner_distance;      ///< shortest ways inside, point to point
};

}  // namespace homolog
