// SPDX-License-Identifier: MIT
// Sec. 4.3: quadratic refinement in space at the refined scale, then in scale at the refined place.
#include "homolog/salient/refine_peak.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>

namespace homolog {
namespace {

constexpr int kCorrectionSteps = 64;  // each way
constexpr int kMostMoves = 4;         // to a neighbouring voxel
constexpr double kBeside = 0.5;       // r: where a ridge is compared with its top

// The response around a voxel to second order.
struct Quadratic {
  double value = 0;
  Vec3 gradient = Vec3::Zero();
  Mat3 hessian = Mat3::Zero();
  double at(const Vec3& d) const { return value + gradient.dot(d) + d.dot(hessian * d) / 2; }
};

Quadratic quadratic_at(const Octave& octave, int level, const std::array<int, 3>& v) {
  const auto f = [&](int i, int j, int k) { return double(octave.at(level, v[0] + i, v[1] + j, v[2] + k)); };
  const auto along = [&](int a, int b, int s, int t) {  // s steps along axis a, t along axis b
    std::array<int, 3> d{0, 0, 0};
    d[a] += s, d[b] += t;
    return f(d[0], d[1], d[2]);
  };
  Quadratic q;
  q.value = f(0, 0, 0);
  for (int a = 0; a < 3; ++a) {
    q.gradient[a] = (along(a, a, 1, 0) - along(a, a, -1, 0)) / 2;
    q.hessian(a, a) = along(a, a, 1, 0) + along(a, a, -1, 0) - 2.0 * q.value;
    for (int b = 0; b < a; ++b) {
      const double alike = along(a, b, 1, 1) + along(a, b, -1, -1), unlike = along(a, b, 1, -1) + along(a, b, -1, 1);
      q.hessian(a, b) = q.hessian(b, a) = (alike - unlike) / 4;
    }
  }
  return q;
}

// Height and offset of the top of the parabola through (-1, a), (0, b), (1, c); the middle if there is no top.
struct Top {
  double offset, value;
};
Top parabola_top(double a, double b, double c) {
  const double bend = a - 2 * b + c;
  if (bend >= 0) return {0, b};
  const double offset = std::clamp((a - c) / (2 * bend), -1.0, 1.0);
  return {offset, b + offset * (c - a) / 2 + offset * offset * bend / 2};
}

// Three levels around a voxel, and between them by the parabola through the three.
struct Stack {
  std::array<Quadratic, 3> levels;

  Quadratic at(double s) const {
    const double below = s * (s - 1) / 2, here = 1 - s * s, above = s * (s + 1) / 2;
    Quadratic q;
    q.value = below * levels[0].value + here * levels[1].value + above * levels[2].value;
    q.gradient = below * levels[0].gradient + here * levels[1].gradient + above * levels[2].gradient;
    q.hessian = below * levels[0].hessian + here * levels[1].hessian + above * levels[2].hessian;
    return q;
  }
  Top scale_top(const Vec3& d) const { return parabola_top(levels[0].at(d), levels[1].at(d), levels[2].at(d)); }
};

Stack stack_at(const Octave& octave, int level, const std::array<int, 3>& voxel) {
  return {{quadratic_at(octave, level - 1, voxel), quadratic_at(octave, level, voxel), quadratic_at(octave, level + 1, voxel)}};
}

// Newton's step to the maximum, at most one cell. Along a direction that bends less than this share of the strongest it stays where it is.
Vec3 step_to_top(const Quadratic& q, double least_bend) {
  const Eigen::SelfAdjointEigenSolver<Mat3> eigen(q.hessian);
  const double strongest = -eigen.eigenvalues()[0];
  Vec3 step = Vec3::Zero();
  for (int a = 0; a < 3; ++a) {
    const double bend = -eigen.eigenvalues()[a];
    if (bend <= least_bend * strongest) continue;
    step += eigen.eigenvectors().col(a) * (eigen.eigenvectors().col(a).dot(q.gradient) / bend);
  }
  return step / std::max(1.0, step.cwiseAbs().maxCoeff());
}

bool inside_margin(const GridFrame& frame, const std::array<int, 3>& v) {
  return frame.contains(v[0] - 1, v[1] - 1, v[2] - 1) && frame.contains(v[0] + 1, v[1] + 1, v[2] + 1);
}

Vec3 vector_of(const std::array<int, 3>& v) { return {double(v[0]), double(v[1]), double(v[2])}; }
std::array<int, 3> nearest_voxel(const Vec3& x) {
  return {static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])), static_cast<int>(std::lround(x[2]))};
}

// The response on the ridge near x: climbs across `along`, not along it, and to the best scale.
double ridge_height(const Octave& octave, int level, double scale_offset, Vec3 x, const Vec3& along) {
  double height = 0;
  for (int move = 0; move < kMostMoves; ++move) {
    const std::array<int, 3> voxel = nearest_voxel(x);
    if (!inside_margin(octave.frame(), voxel)) break;
    const Stack stack = stack_at(octave, level, voxel);
    const Vec3 d = x - vector_of(voxel);
    Quadratic q = stack.at(scale_offset);
    q.gradient += q.hessian * d;
    Vec3 step = step_to_top(q, 0.05);
    step -= along * along.dot(step);
    height = stack.scale_top(d + step).value;
    x += step;
    if (step.norm() < 0.05) break;
  }
  return height;
}

// The share by which the response falls within kBeside r along the direction in which it bends second to least, the lesser of both ways.
double sheet_fall(const Octave& octave, int level, const Mat3& hessian, const Vec3& x, const Top& top, double radius) {
  const Vec3 along = Eigen::SelfAdjointEigenSolver<Mat3>(hessian).eigenvectors().col(1);
  double higher = 0;
  for (const double way : {-kBeside, kBeside}) {
    higher = std::max(higher, ridge_height(octave, level, top.offset, x + way * radius * along, along));
  }
  return 1 - higher / top.value;
}

}  // namespace

int refinement_reach(const SalientParams& params) {
  const double k = std::pow(2, 1.0 / params.levels_per_octave);
  const double largest_radius = radius_factor(k) * params.sigma0 * 2 * std::pow(k, 1.5);  // of the last inner level, at the next scale
  const double on_ridge = kBeside * largest_radius + (kMostMoves - 1) * std::sqrt(3.0) + 0.5;
  return kMostMoves + 1 + static_cast<int>(std::ceil(on_ridge)) + 1;  // the peak's own moves, its last step; the neighbours asked
}

ScaleCorrection::ScaleCorrection(double k) {
  const double best = 1 / radius_factor(k);
  for (int i = -kCorrectionSteps; i <= kCorrectionSteps; ++i) {
    const double middle = best * std::pow(k, -double(i) / kCorrectionSteps);  // the ball's best scale lies i / steps above this level
    const Top top = parabola_top(-ball_level(middle / k, k), -ball_level(middle, k), -ball_level(middle * k, k));
    parabola_offsets_.push_back(top.offset);
  }
}

double ScaleCorrection::operator()(double parabola_offset) const {
  const auto above = std::lower_bound(parabola_offsets_.begin(), parabola_offsets_.end(), parabola_offset);
  if (above == parabola_offsets_.begin()) return -1;
  if (above == parabola_offsets_.end()) return 1;
  const double share = (parabola_offset - above[-1]) / (above[0] - above[-1]);
  return (static_cast<double>(above - parabola_offsets_.begin()) - 1 + share) / kCorrectionSteps - 1;
}

RefinedPeak refine_peak(const Octave& octave, const Peak& peak, double k, const ScaleCorrection& correction) {
  std::array<int, 3> voxel = peak.voxel;
  Stack stack = stack_at(octave, peak.level, voxel);
  Top top{0, stack.levels[1].value};
  Vec3 d = Vec3::Zero();
  for (int move = 0; move < kMostMoves; ++move) {
    d = step_to_top(stack.at(top.offset), 1e-3);
    top = stack.scale_top(d);
    if (d.cwiseAbs().maxCoeff() <= 0.6) continue;  // same voxel: the next round only settles place and scale together
    const std::array<int, 3> next = nearest_voxel(vector_of(voxel) + d);
    if (!inside_margin(octave.frame(), next)) break;
    voxel = next;
    stack = stack_at(octave, peak.level, voxel);
    d.setZero();
  }
  const GridFrame& frame = octave.frame();
  const Vec3 x = vector_of(voxel) + d;
  RefinedPeak refined;
  refined.point.position = frame.world_from_voxel(x);
  refined.point.radius = radius_factor(k) * octave.sigmas[peak.level] * std::pow(k, correction(top.offset));
  refined.point.response = top.value;
  refined.sheet_fall = sheet_fall(octave, peak.level, stack.at(top.offset).hessian, x, top, refined.point.radius / frame.spacing);
  return refined;
}

}  // namespace homolog
