// SPDX-License-Identifier: MIT
#include "homolog/describe/turn_shape.h"

namespace homolog {

void turn_shape(Shape& shape, const Mat3& rotation) {
  const auto turn = [&](Vec3& v) { v = rotation * v; };
  GridFrame& frame = shape.interior.frame;
  turn(frame.origin);
  frame.axes = rotation * frame.axes;
  for (SalientPoint& point : shape.points) {
    turn(point.position);
    turn(point.direction);
  }
  for (SurfaceSample& sample : shape.surface) {
    turn(sample.position);
    turn(sample.normal);
  }
  for (Vec3& node : shape.body.nodes) turn(node);
  for (Vec3& normal : shape.body.normals) turn(normal);
}

}  // namespace homolog
