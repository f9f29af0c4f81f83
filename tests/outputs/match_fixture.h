// SPDX-License-Identifier: MIT
// Two small shapes and a family of one match between them, made by hand.
#pragma once

#include "homolog/homolog.h"

namespace homolog::fixtures {

inline SalientPoint point(double x, double y, double z, double radius) {
  SalientPoint p;
  p.position = {x, y, z};
  p.radius = radius;
  p.direction = Vec3(0, 1, 0);
  p.direction_length = 0.5;
  p.response = 0.75;
  return p;
}

inline Shape shape(const std::string& name, double scale) {
  Shape s;
  s.name = name;
  s.diagonal = 10 * scale;
  s.points = {point(0.1 * scale, 0, 0, 3 * scale), point(1 * scale, 2 * scale, 0, 2 * scale), point(0, 1 * scale, 1 * scale / 3, scale)};
  s.points.back().direction_length = 0;
  return s;
}

inline Family family(const Shape& model, const Shape& data) {
  Match match;
  for (int i : {0, 2}) match.pairs.push_back({i, i, model.points[i], data.points[i], 0.125, 0.5 + 0.1 * i});
  match.data_from_model.centres = {model.points[0].position};
  match.data_from_model.weights = {Vec3(0, 0, 0.1)};
  match.similarity = {2, Mat3::Identity(), Vec3(0, 0, 7)};
  match.confidence = 0.9;
  match.bending = 1e-3;
  match.chamfer = 0.0123456789012345678;
  match.model_coverage = 0.5;
  match.data_coverage = 1;
  return {{match}, {{{"candidates", 12}, {"seeds", 3}, {"verified", 1}}}};
}

}  // namespace homolog::fixtures
