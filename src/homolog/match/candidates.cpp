// SPDX-License-Identifier: MIT
#include "homolog/match/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "homolog/base/parallel.h"

namespace homolog {
namespace {

// Marks the `kept` smallest of the distances that `entry(n)` gives for n < count.
template <class Entry, class Mark>
void mark_nearest(int count, int kept, Entry entry, Mark mark) {
  std::vector<std::pair<double, int>> order;
  for (int n = 0; n < count; ++n) order.emplace_back(entry(n), n);
  std::sort(order.begin(), order.end());
  for (int n = 0; n < std::min(kept, count); ++n) mark(order[n].second);
}

// Marks the points that answer strongest, all if there are no more than `most`.
std::vector<char> strongest(const std::vector<SalientPoint>& points, int most) {
  std::vector<char> marks(points.size(), 0);
  mark_nearest(
      static_cast<int>(points.size()), most, [&](int n) { return -points[n].response; }, [&](int n) { marks[n] = 1; });
  return marks;
}

}  // namespace

CorrespondenceSet find_candidates(const Shape& model, const Shape& data, const Params& params) {
  const int rows = static_cast<int>(model.points.size()), columns = static_cast<int>(data.points.size());
  const std::vector<char> in_model = strongest(model.points, params.match.searched_points),
                          in_data = strongest(data.points, params.match.searched_points);
  Eigen::MatrixXd distance = Eigen::MatrixXd::Constant(rows, columns, std::numeric_limits<double>::infinity());
  parallel_for(rows, [&](std::size_t i) {
    for (int j = 0; j < columns; ++j) {
      if (!in_model[i] || !in_data[j]) continue;
      distance(i, j) = descriptor_distance(model.descriptors[i], data.descriptors[j], params.descriptor.kind);
    }
  });
  Eigen::MatrixXi chosen = Eigen::MatrixXi::Zero(rows, columns);
  const int kept = params.match.partners;
  for (int i = 0; i < rows; ++i) {
    mark_nearest(
        columns, kept, [&](int j) { return distance(i, j); }, [&](int j) { chosen(i, j) = 1; });
  }
  for (int j = 0; j < columns; ++j) {
    mark_nearest(
        rows, kept, [&](int i) { return distance(i, j); }, [&](int i) { chosen(i, j) = 1; });
  }
  const double limit = params.match.seeds == Seeds::quadruples ? params.paper.descriptor_limit : 0;
  CorrespondenceSet candidates;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const bool too_far = limit > 0 && distance(i, j) >= limit;  // eq. 7
      if (chosen(i, j) && std::isfinite(distance(i, j)) && !too_far)
        candidates.push_back({i, j, model.points[i], data.points[j], distance(i, j), 0});
    }
  }
  return candidates;
}

}  // namespace homolog
