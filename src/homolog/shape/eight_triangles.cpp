// SPDX-License-Identifier: MIT
#include "homolog/shape/eight_triangles.h"

#include <limits>

#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();

struct Vector {
  double x, y, z;
};

// A place of a triangle as shares of its corners.
struct Place {
  double a, b, c, square;  ///< square of its distance
};

[[gnu::always_inline]] inline double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

[[gnu::always_inline]] inline Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// By member: a choice between whole structs would be a jump, which ends the vectors.
[[gnu::always_inline]] inline Place nearer(const Place& p, const Place& q) {
  const bool second = q.square < p.square;
  return {second ? q.a : p.a, second ? q.b : p.b, second ? q.c : p.c, second ? q.square : p.square};
}

// Nearest to the origin on the edge ab, as a place of the triangle whose third corner is c.
[[gnu::always_inline]] inline Place on_edge(const Vector& a, const Vector& b) {
  const Vector edge{b.x - a.x, b.y - a.y, b.z - a.z};
  const double length = dot(edge, edge), along = -dot(a, edge);
  const double t = along > 0 ? (along < length ? along / length : 1.0) : 0.0;
  const Vector place{a.x + t * edge.x, a.y + t * edge.y, a.z + t * edge.z};
  return {1 - t, t, 0, dot(place, place)};
}

// The foot of the perpendicular from the origin, if it lies within. The normal is b x c + c x a + a x b, and these three are as long
// along it as the shares of a, b and c. A sliver's normal is mostly rounding: its edges come nearer then.
[[gnu::always_inline]] inline Place inside(const Vector& a, const Vector& b, const Vector& c) {
  const Vector bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
  const Vector normal{bc.x + ca.x + ab.x, bc.y + ca.y + ab.y, bc.z + ca.z + ab.z};
  const double along_a = dot(bc, normal), along_b = dot(ca, normal), along_c = dot(ab, normal);
  const double sum = along_a + along_b + along_c, over = 1 / (sum > 0 ? sum : 1.0);
  const double p = over * along_a, q = over * along_b, r = over * along_c;
  const Vector foot{p * a.x + q * b.x + r * c.x, p * a.y + q * b.y + r * c.y, p * a.z + q * b.z + r * c.z};
  const double least_bc = along_b < along_c ? along_b : along_c, least = along_a < least_bc ? along_a : least_bc;
  return {p, q, r, least >= 0 ? (sum > 0 ? dot(foot, foot) : nowhere) : nowhere};
}

// A loop over the triangles, which the compiler turns into vectors.
HOMOLOG_WIDEST_CLONE void find_nearest(const EightTriangles& triangles, double x, double y, double z, EightPlaces& __restrict places) {
  const auto& corner = triangles.corners;
  for (std::size_t i = 0; i < triangles_at_once; ++i) {
    const Vector a{corner[0][0][i] - x, corner[0][1][i] - y, corner[0][2][i] - z};
    const Vector b{corner[1][0][i] - x, corner[1][1][i] - y, corner[1][2][i] - z};
    const Vector c{corner[2][0][i] - x, corner[2][1][i] - y, corner[2][2][i] - z};
    const Place ab = on_edge(a, b), bc = on_edge(b, c), ca = on_edge(c, a);
    const Place edge = nearer(nearer(ab, {bc.c, bc.a, bc.b, bc.square}), {ca.b, ca.c, ca.a, ca.square});
    const Place nearest = nearer(edge, inside(a, b, c));
    places.barycentric[0][i] = nearest.a;
    places.barycentric[1][i] = nearest.b;
    places.barycentric[2][i] = nearest.c;
    places.square_distance[i] = nearest.square;
  }
}

}  // namespace

EightPlaces nearest_places(const EightTriangles& triangles, const Vec3& x) {
  EightPlaces places;
  find_nearest(triangles, x.x(), x.y(), x.z(), places);
  return places;
}

}  // namespace homolog
