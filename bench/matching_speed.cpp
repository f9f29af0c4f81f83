// SPDX-License-Identifier: MIT
#include "matching_speed.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>

#include "fixtures/solids.h"
#include "homolog/base/parallel.h"
#include "homolog/homolog.h"
#include "homolog/match/coverage.h"
#include "homolog/match/dense.h"
#include "homolog/outputs/match_json.h"
#include "homolog/shape/read_mesh.h"
#include "speed_rows.h"
#include "stage_times.h"

namespace homolog::bench {
namespace {

constexpr int mesh_resolution = 52;  // hand and biplane have about 10 000 vertices then
constexpr int voxels_of_a_hand = 128;

// A ball with bumps of three sizes, evenly strewn, each about a salient point.
fixtures::Solid bumpy_ball(int bumps) {
  std::vector<fixtures::Solid> solids{fixtures::ball(Vec3::Zero(), 1)};
  const double turn = M_PI * (3 - std::sqrt(5.0)), spacing = std::sqrt(4 * M_PI / bumps);
  for (int i = 0; i < bumps; ++i) {
    const double z = 1 - 2 * (i + 0.5) / bumps, r = std::sqrt(1 - z * z);
    solids.push_back(fixtures::ball({r * std::cos(turn * i), r * std::sin(turn * i), z}, spacing * (0.2 + 0.05 * (7 * i % 3))));
  }
  return fixtures::join(solids);
}

// So many hands in rows, all turned otherwise.
fixtures::Solid hands(int count) {
  std::vector<fixtures::Solid> solids;
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    const Vec3 place(2.2 * (i % columns), 2.2 * (i / columns), 0);
    solids.push_back(fixtures::moved(fixtures::hand(), {Eigen::AngleAxisd(i, Vec3::UnitZ()).toRotationMatrix(), 1, place}));
  }
  return fixtures::join(solids);
}

double longest_side(const fixtures::Solid& solid) {
  const Box box = fixtures::bounding_box(solid);
  return (box.max - box.min).maxCoeff();
}

// Turned, larger, and drawn out on one side.
Mesh changed(Mesh mesh) {
  const Mat3 turn = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& v : mesh.vertices) v = 1.7 * (turn * (v + Vec3(0.1 * v.x() * v.x(), 0, 0)));
  return mesh;
}

void print_stages(const std::vector<Stage>& stages) {
  for (const Stage& stage : stages) {
    fmt::print("  {:20} {:9.1f} CPU ms  {} {}\n", stage.name, stage.cpu_milliseconds, stage.count, stage.counted);
  }
  fmt::print("  {:20} {:9.1f} CPU ms\n", "all", sum_of(stages, &Stage::cpu_milliseconds));
  std::fflush(stdout);
}

struct MeshPair {
  Mesh model, data;
};

// What `homolog dense` reckons for a match that is known: the place of every vertex of either mesh on the other one.
void measure_dense_maps(const MeshPair& meshes, const MatchingOptions& options) {
  Params params;
  params.threads = 1;
  const Shape model = describe_shape(meshes.model, params), data = describe_shape(meshes.data, params);
  std::vector<Match> matches = match_shapes(model, data, params).matches;
  if (matches.empty()) return;
  matches.resize(1);
  const ThreadLimit one_thread(1);
  const auto stages = best_stages(options.repeats, [&](Stopwatch& watch) {
    const auto parts = covered_parts({meshes.model, model}, {meshes.data, data}, matches);
    watch.lap("covered parts", matches.size(), "matches");
    dense_maps(match_maps(matches, model, data, parts).front(), meshes.model, meshes.data);
    watch.lap("dense maps", meshes.model.vertices.size() + meshes.data.vertices.size(), "vertices");
  });
  fmt::print("dense refinement of the first match, one thread\n");
  print_stages(stages);
}

using Reading = std::function<Mesh(Stopwatch&)>;

void match_whole(const Reading& read_model, const Reading& read_data, const Params& params, Stopwatch& watch) {
  const Shape model = describe_shape(read_model(watch), params, {}, &watch);
  const Shape data = describe_shape(read_data(watch), params, {}, &watch);
  const Family family = match_shapes(model, data, params, &watch);
  const std::string json = match_json(model, data, family, params);
  watch.lap("JSON", json.size(), "bytes");
}

void measure_whole_match(const std::string& name, const Reading& model, const Reading& data, const MatchingOptions& options,
                         const MachineFloor& floor) {
  measure_on_grids(name, options, floor, [&](const Params& params, Stopwatch& watch) { match_whole(model, data, params, watch); });
  Stopwatch unwatched;
  measure_dense_maps({model(unwatched), data(unwatched)}, options);
}

Reading reading(const std::string& file) {
  return [file](Stopwatch& watch) {
    Mesh mesh = read_mesh(file);
    watch.lap("reading", mesh.triangles.size(), "triangles");
    return mesh;
  };
}

// On a grid so fine that even the bumps of five hundred are larger than the finest blur.
Params params_of_points() {
  Params params;
  params.voxel.resolution = 384;
  params.threads = 1;
  params.match.searched_points = 2000;
  return params;
}

}  // namespace

void measure_on_grids(const std::string& name, const MatchingOptions& options, const MachineFloor& floor,
                      const std::function<void(const Params&, Stopwatch&)>& work) {
  Growth growth;
  for (const int grid : options.grids) {
    for (const int threads : options.threads) {
      Params params;
      params.voxel.resolution = grid;
      params.threads = threads;
      const auto stages = best_stages(options.repeats, [&](Stopwatch& watch) { work(params, watch); });
      print_speed_rows({name, grid, threads}, stages, floor);
      if (threads == 1) add_times(growth, grid, by_name(stages));
    }
  }
  if (const std::string told = told_exponents(growth, "N"); !told.empty()) fmt::print("{:14} CPU time grows as{}\n", name, told);
}

void measure_whole_matches(const MatchingOptions& options, const MachineFloor& floor) {
  const std::pair<const char*, fixtures::Solid> solids[] = {{"hand", fixtures::hand()}, {"biplane", fixtures::biplane()}};
  fmt::print("\nhomolog match, both shapes read, described and matched; stages of the two together\n");
  print_speed_header();
  for (const auto& [name, solid] : solids) {
    const Mesh model = mesh_of(solid, mesh_resolution), data = changed(model);
    fmt::print("{} of {} vertices, and changed\n", name, model.vertices.size());
    const auto made = [](const Mesh& mesh) { return [&mesh](Stopwatch&) { return mesh; }; };
    measure_whole_match(name, made(model), made(data), options, floor);
  }
  for (const auto& [model, data] : options.pairs) {
    fmt::print("{} and {}\n", std::filesystem::path(model).filename().string(), std::filesystem::path(data).filename().string());
    measure_whole_match(std::filesystem::path(model).stem().string(), reading(model), reading(data), options, floor);
  }
}

void measure_points(const MatchingOptions& options) {
  Growth growth;
  for (const int bumps : options.points) {
    if (bumps == 0) continue;
    const Mesh mesh = mesh_of(bumpy_ball(bumps), 256);
    const Params params = params_of_points();
    const Shape model = describe_shape(mesh, params), data = describe_shape(changed(mesh), params);
    const auto stages = best_stages(options.repeats, [&](Stopwatch& watch) { match_shapes(model, data, params, &watch); });
    fmt::print("\nmatching {} with {} points, one thread\n", model.points.size(), data.points.size());
    print_stages(stages);
    add_times(growth, std::sqrt(static_cast<double>(model.points.size() * data.points.size())), stages);
  }
  if (const std::string told = told_exponents(growth, "P"); !told.empty()) fmt::print("CPU time grows with the points as{}\n", told);
}

void measure_copies(const MatchingOptions& options) {
  Params params;
  params.threads = 1;
  params.voxel.resolution = voxels_of_a_hand;
  const Mesh hand = mesh_of(fixtures::hand(), mesh_resolution);
  const Shape model = describe_shape(hand, params);
  Growth growth;
  for (const int copies : options.copies) {
    if (copies == 0) continue;
    const fixtures::Solid solids = hands(copies);
    const double larger = longest_side(solids) / longest_side(fixtures::hand());
    params.voxel.resolution = static_cast<int>(larger * voxels_of_a_hand);
    const Mesh scene = mesh_of(solids, static_cast<int>(larger * mesh_resolution));
    const Shape data = describe_shape(scene, params);
    const auto stages = best_stages(options.repeats, [&](Stopwatch& watch) {
      const Family family = match_shapes(model, data, params, &watch);
      covered_parts({hand, model}, {scene, data}, family.matches);
      watch.lap("parts", family.matches.size(), "matches");
    });
    fmt::print("\nmatching a hand with {}, {} vertices, one thread\n", copies, scene.vertices.size());
    print_stages(stages);
    if (stages.back().count > 0) add_times(growth, static_cast<double>(stages.back().count), stages);
  }
  if (const std::string told = told_exponents(growth, "M"); !told.empty()) fmt::print("CPU time grows with the matches told as{}\n", told);
}

}  // namespace homolog::bench
