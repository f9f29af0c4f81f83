// SPDX-License-Identifier: MIT
// Rays along x and y are followed layer by layer of z, and what they say is used at once. Rays along z are followed before that, layer by
// layer of y, and only where their sums change is kept.
#include "homolog/shape/axis_sums.h"

#include <algorithm>

#include "homolog/base/parallel.h"
#include "homolog/base/widest_clone.h"

namespace homolog {
namespace {

constexpr int layers_a_task = 16;

struct Change {
  std::uint32_t x;
  std::int32_t difference;
};

/// What the rays along z say of a layer of y: changes[begin[z]] to changes[begin[z + 1]] lie between z - 1 and z.
struct ChangesAlongZ {
  std::vector<std::uint32_t> begin;
  std::vector<Change> changes;
  std::vector<std::int32_t> before_task;  ///< the sums before every layers_a_task-th layer of z, row by row
  std::vector<float> lost;
  bool any_lost;
};

int tasks_for(int layers) { return (layers + layers_a_task - 1) / layers_a_task; }

template <class Body>
void for_each_task(int layers, const Body& body) {
  parallel_for(tasks_for(layers), [&](std::size_t task) {
    const int first = static_cast<int>(task) * layers_a_task;
    body(first, std::min(first + layers_a_task, layers));
  });
}

bool is_zero(const std::int32_t* row, std::size_t x) {
  std::int32_t any = 0;
  for (std::size_t i = 0; i < 16; ++i) any |= row[x + i];
  return any == 0;
}

/// Takes the changes out of a layer, which is left empty.
HOMOLOG_WIDEST_CLONE void take_changes(const std::array<int, 3>& size, Layer& layer, ChangesAlongZ& along) {
  std::vector<std::int32_t> sums(size[0], 0);
  for (int z = 0; z < size[2]; ++z) {
    if (z % layers_a_task == 0) along.before_task.insert(along.before_task.end(), sums.begin(), sums.end());
    along.begin.push_back(static_cast<std::uint32_t>(along.changes.size()));
    std::int32_t* row = layer.differences.data() + z * layer.stride;
    for (std::size_t block = 0; block < layer.stride; block += 16) {
      if (is_zero(row, block)) continue;
      for (std::size_t x = block; x < block + 16; ++x) {
        if (row[x] == 0) continue;
        along.changes.push_back({static_cast<std::uint32_t>(x), row[x]});
        sums[x] += row[x];
        row[x] = 0;
      }
    }
  }
  along.begin.push_back(static_cast<std::uint32_t>(along.changes.size()));
  along.lost = layer.lost;
  along.any_lost = layer.any_lost;
}

std::vector<ChangesAlongZ> follow_z(const GridSurface& surface, const RayBundle& bundle) {
  std::vector<ChangesAlongZ> all(surface.size[1]);
  for_each_task(surface.size[1], [&](int first, int end) {
    LayerRays rays(surface, bundle);
    Layer layer = rays.empty_layer();
    for (int y = first; y < end; ++y) {
      rays.follow(y, layer);
      take_changes(surface.size, layer, all[y]);
    }
  });
  return all;
}

/// Differences along a row become their sums.
HOMOLOG_WIDEST_CLONE void sum_along(std::int32_t* row, std::size_t length) {
  std::int32_t sum = 0;
  for (std::size_t block = 0; block < length; block += 16) {
    if (is_zero(row, block)) {
      std::fill(row + block, row + block + 16, sum);
    } else {
      for (std::size_t x = block; x < block + 16; ++x) row[x] = sum += row[x];
    }
  }
}

/// Adds differences to the sums of the row before and forgets them.
HOMOLOG_WIDEST_CLONE void sum_across(std::int32_t* differences, std::int32_t* sums, std::size_t length) {
  for (std::size_t x = 0; x < length; ++x) {
    sums[x] += differences[x];
    differences[x] = 0;
  }
}

}  // namespace

void visit_axis_sums(const GridSurface& surface, const std::function<void(const RowSums&)>& visit) {
  std::array<RayBundle, 3> bundles;
  parallel_for(3, [&](std::size_t axis) { bundles[axis] = make_bundle(surface, static_cast<int>(axis)); });
  const std::vector<ChangesAlongZ> along_z = follow_z(surface, bundles[2]);
  const std::size_t nx = surface.size[0], ny = surface.size[1];
  for_each_task(surface.size[2], [&](int first, int end) {
    LayerRays rays_x(surface, bundles[0]), rays_y(surface, bundles[1]);
    Layer layer_x = rays_x.empty_layer(), layer_y = rays_y.empty_layer();
    std::vector<std::int32_t> sums_y(layer_y.stride), sums_z(nx * ny);
    for (std::size_t y = 0; y < ny; ++y) {
      const auto before = along_z[y].before_task.begin() + static_cast<std::ptrdiff_t>(first / layers_a_task * nx);
      std::copy(before, before + static_cast<std::ptrdiff_t>(nx), sums_z.begin() + static_cast<std::ptrdiff_t>(y * nx));
    }
    for (int z = first; z < end; ++z) {
      rays_x.follow(z, layer_x);
      rays_y.follow(z, layer_y);
      std::fill(sums_y.begin(), sums_y.end(), 0);
      for (std::size_t y = 0; y < ny; ++y) {
        std::int32_t* row_x = layer_x.differences.data() + y * layer_x.stride;
        sum_along(row_x, layer_x.stride);
        sum_across(layer_y.differences.data() + y * layer_y.stride, sums_y.data(), layer_y.stride);
        const ChangesAlongZ& along = along_z[y];
        for (std::uint32_t i = along.begin[z]; i < along.begin[z + 1]; ++i)
          sums_z[y * nx + along.changes[i].x] += along.changes[i].difference;
        visit({static_cast<int>(y),
               z,
               {row_x, sums_y.data(), sums_z.data() + y * nx},
               layer_x.lost[y],
               layer_y.lost.data(),
               along.lost.data(),
               layer_x.lost[y] > 0 || layer_y.any_lost || along.any_lost});
        std::fill(row_x, row_x + layer_x.stride, 0);
      }
      std::fill(layer_y.differences.begin() + static_cast<std::ptrdiff_t>(ny * layer_y.stride), layer_y.differences.end(), 0);
    }
  });
}

}  // namespace homolog
