// SPDX-License-Identifier: MIT
// Where the time goes: every stage on shapes made in code and on files, grids from coarse to fine, one thread and all; beside what the
// machine could do at best, measured in the same run. It reports and judges nothing.
#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fixtures/solids.h"
#include "homolog/homolog.h"
#include "homolog/shape/read_mesh.h"
#include "machine_floor.h"

namespace homolog::bench {
namespace {

constexpr int mesh_resolution = 160;  // the ball has 720 000 triangles then

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

struct Options {
  std::vector<std::string> files;
  std::vector<int> grids{64, 128, 192, 256, 512}, threads{1, 0}, points;
  int repeats = 3;
};

std::vector<NamedMesh> meshes_of(const Options& options) {
  std::vector<NamedMesh> meshes{{"ball", mesh_of(fixtures::ball(Vec3::Zero(), 1), mesh_resolution)},
                                {"hand", mesh_of(fixtures::hand(), mesh_resolution)},
                                {"biplane", mesh_of(fixtures::biplane(), mesh_resolution)}};
  for (const std::string& file : options.files) meshes.push_back({std::filesystem::path(file).stem().string(), read_mesh(file)});
  return meshes;
}

// Lets peak_memory() begin anew, where the system can.
void forget_peak() {
  malloc_trim(0);
  if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {
    std::fputs("5", file);
    std::fclose(file);
  }
}

// The stages of `repeats` runs of the same work: the least time of each.
template <class Work>
std::vector<Stage> best_stages(int repeats, const Work& work) {
  std::vector<Stage> best;
  for (int run = 0; run < repeats; ++run) {
    forget_peak();
    Stopwatch watch;
    work(watch);
    if (best.empty()) best = watch.stages();
    for (std::size_t i = 0; i < best.size(); ++i) {
      best[i].milliseconds = std::min(best[i].milliseconds, watch.stages()[i].milliseconds);
      best[i].cpu_milliseconds = std::min(best[i].cpu_milliseconds, watch.stages()[i].cpu_milliseconds);
      best[i].peak_bytes = std::min(best[i].peak_bytes, watch.stages()[i].peak_bytes);
    }
  }
  return best;
}

double sum_of(const std::vector<Stage>& stages, double Stage::*what) {
  double sum = 0;
  for (const Stage& stage : stages) sum += stage.*what;
  return sum;
}

// Slope of log time against log grid, by least squares.
double exponent(const std::vector<std::pair<int, double>>& times) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(times.size());
  for (const auto& [grid, time] : times) {
    const double log_grid = std::log(grid), log_time = std::log(std::max(time, 1e-3));
    x += log_grid, y += log_time, xx += log_grid * log_grid, xy += log_grid * log_time;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

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

// Turned, larger, and drawn out on one side.
Mesh changed(Mesh mesh) {
  const Mat3 turn = Eigen::AngleAxisd(1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& v : mesh.vertices) v = 1.7 * (turn * (v + Vec3(0.1 * v.x() * v.x(), 0, 0)));
  return mesh;
}

// Every point of the two is searched.
void measure_matching(int bumps, const Options& options) {
  const Mesh mesh = mesh_of(bumpy_ball(bumps), 256);
  Params params;
  params.voxel.resolution = 384;  // so that even the bumps of five hundred are larger than the finest blur
  params.threads = 1;
  params.match.points = 2000;
  const Shape model = describe_shape(mesh, params), data = describe_shape(changed(mesh), params);
  fmt::print("\nmatching {} with {} points, one thread\n", model.points.size(), data.points.size());
  for (const Stage& stage : best_stages(options.repeats, [&](Stopwatch& watch) { match_shapes(model, data, params, &watch); })) {
    fmt::print("  {:20} {:9.1f} CPU ms  {} {}\n", stage.name, stage.cpu_milliseconds, stage.count, stage.counted);
  }
  std::fflush(stdout);
}

void print_header() {
  fmt::print("\n{:14} {:>5} {:>7}  {:20} {:>9} {:>9} {:>9} {:>9}  of\n", "shape", "grid", "threads", "stage", "ms", "CPU ms", "x floor",
             "peak MiB");
}

void print_rows(const NamedMesh& shape, int grid, int threads, const std::vector<Stage>& stages, const MachineFloor& floor) {
  const auto row = [&](const std::string& name, double ms, double cpu, const std::string& ratio, std::size_t peak, const std::string& of) {
    fmt::print("{:14} {:5} {:>7}  {:20} {:9.1f} {:9.1f} {:>9} {:9.1f}  {}\n", shape.name, grid,
               threads == 0 ? "all" : std::to_string(threads), name, ms, cpu, ratio, static_cast<double>(peak) / (1 << 20), of);
  };
  for (const Stage& stage : stages) {
    std::string ratio;
    if (stage.name == "salient points") {
      ratio = fmt::format("{:.2f}", stage.cpu_milliseconds / scale_space_floor_ms(floor, static_cast<double>(stages[0].count)));
    }
    row(stage.name, stage.milliseconds, stage.cpu_milliseconds, ratio, stage.peak_bytes, fmt::format("{} {}", stage.count, stage.counted));
  }
  row("all", sum_of(stages, &Stage::milliseconds), sum_of(stages, &Stage::cpu_milliseconds), "", stages.back().peak_bytes, "");
  std::fflush(stdout);
}

void measure_shape(const NamedMesh& shape, const Options& options, const MachineFloor& floor) {
  std::map<std::string, std::vector<std::pair<int, double>>> times;  // CPU ms of a stage by grid, one thread
  for (const int grid : options.grids) {
    for (const int threads : options.threads) {
      Params params;
      params.voxel.resolution = grid;
      params.threads = threads;
      const auto stages = best_stages(options.repeats, [&](Stopwatch& watch) { describe_shape(shape.mesh, params, {}, &watch); });
      print_rows(shape, grid, threads, stages, floor);
      if (threads != 1) continue;
      for (const Stage& stage : stages) times[stage.name].emplace_back(grid, stage.cpu_milliseconds);
      times["all"].emplace_back(grid, sum_of(stages, &Stage::cpu_milliseconds));
    }
  }
  if (options.grids.size() < 2) return;
  fmt::print("{:14} CPU time grows with the grid N as", shape.name);
  for (const auto& [stage, by_grid] : times) fmt::print("  {} N^{:.1f}", stage, exponent(by_grid));
  fmt::print("\n");
}

int run(int argc, char** argv) {
  CLI::App app{"Time and memory of every stage of describe_shape, beside the machine's floor"};
  Options options;
  app.add_option("files", options.files, "Meshes, besides those made in code");
  app.add_option("--grids", options.grids, "Voxels along the longest side")->delimiter(',')->capture_default_str();
  app.add_option("--threads", options.threads, "Numbers of threads, 0 for all cores")->delimiter(',')->capture_default_str();
  app.add_option("--points", options.points, "Besides, match two balls with about so many points")->delimiter(',');
  app.add_option("--repeats", options.repeats, "Runs of everything, of which the best counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  CLI11_PARSE(app, argc, argv);
  const MachineFloor floor = measure_floor();
  fmt::print("this machine, one thread: copy {:.1f} GB/s, fused multiply-add {:.0f} GFLOP/s (AVX2 where there is)\n", floor.copy_gb_per_s,
             floor.fma_gflop_per_s);
  fmt::print("x floor: CPU time over that of the dense pyramid's arithmetic on the voxels of the grid ({:.1f} ms at 128^3)\n",
             scale_space_floor_ms(floor, 128.0 * 128 * 128));
  print_header();
  for (const NamedMesh& shape : meshes_of(options)) measure_shape(shape, options, floor);
  for (const int bumps : options.points) measure_matching(bumps, options);
  return 0;
}

}  // namespace
}  // namespace homolog::bench

int main(int argc, char** argv) {
  try {
    return homolog::bench::run(argc, argv);
  } catch (const homolog::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
