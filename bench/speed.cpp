// SPDX-License-Identifier: MIT
// Where the time goes: every stage on shapes made in code and on files, grids from coarse to fine, one thread and all; beside what the
// machine could do at best, measured in the same run. It reports and judges nothing.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "fixtures/solids.h"
#include "homolog/homolog.h"
#include "homolog/shape/read_mesh.h"
#include "machine.h"
#include "machine_floor.h"
#include "matching_speed.h"
#include "process_time.h"
#include "speed_rows.h"

namespace homolog::bench {
namespace {

constexpr int mesh_resolution = 160;
constexpr int ball_resolution = 103;  // 300 000 triangles
constexpr int starts = 20;            // of the program

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

struct Options {
  std::vector<std::string> files;
  std::string program;
  MatchingOptions matching{{64, 128, 192, 256, 512}, {1, 0}, {30, 100, 500}, {1, 2, 4}, {}, 3};
  bool quick = false;
};

std::vector<NamedMesh> meshes_of(const Options& options) {
  std::vector<NamedMesh> meshes{{"ball", mesh_of(fixtures::ball(Vec3::Zero(), 1), ball_resolution)},
                                {"hand", mesh_of(fixtures::hand(), mesh_resolution)},
                                {"biplane", mesh_of(fixtures::biplane(), mesh_resolution)}};
  for (const std::string& file : options.files) meshes.push_back({std::filesystem::path(file).stem().string(), read_mesh(file)});
  return meshes;
}

void measure_shape(const NamedMesh& shape, const MatchingOptions& options, const MachineFloor& floor) {
  measure_on_grids(shape.name, options, floor,
                   [&](const Params& params, Stopwatch& watch) { describe_shape(shape.mesh, params, {}, &watch); });
}

void add_options(CLI::App& app, Options& options) {
  MatchingOptions& matching = options.matching;
  app.add_option("files", options.files, "Meshes, besides those made in code");
  app.add_option("--pair", matching.pairs, "Besides, match these two files; may stand several times")->type_name("MODEL DATA");
  app.add_option("--program", options.program, "The built homolog: besides, its start, and matches of the pairs as whole processes");
  app.add_option("--grids", matching.grids, "Voxels along the longest side")->delimiter(',')->capture_default_str();
  app.add_option("--threads", matching.threads, "Numbers of threads, 0 for all cores")->delimiter(',')->capture_default_str();
  app.add_option("--points", matching.points, "Match two balls with about so many points; 0 for none")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--copies", matching.copies, "Match a hand with so many of them; 0 for none")->delimiter(',')->capture_default_str();
  app.add_option("--repeats", matching.repeats, "Runs of everything, of which the best counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
  app.add_flag("--quick", options.quick, "One run on grids 64 and 128, one thread, 30 points, 1 and 2 copies: to see that all works");
}

// What the ratios of the table below mean on this machine.
void print_floor(const MachineFloor& floor) {
  fmt::print("this machine, one thread: copy {:.1f} GB/s, fused multiply-add {:.0f} GFLOP/s (AVX2 where there is)\n", floor.copy_gb_per_s,
             floor.fma_gflop_per_s);
  const double example = 128.0 * 128 * 128;
  fmt::print(
      "x floor: CPU time over that of the dense pyramid's arithmetic on the voxels of the grid ({:.1f} ms at 128^3); x cube: on as many as "
      "a cube has that is as long\n",
      scale_space_floor_ms(floor, example));
  fmt::print(
      "x copy: CPU time over that of moving once what the stage must read and write (at 128^3: voxels {:.1f} ms, salient points {:.1f}, "
      "descriptors {:.1f})\n",
      copy_floor_ms(floor, "voxels", example), copy_floor_ms(floor, "salient points", example),
      copy_floor_ms(floor, "descriptors", example));
}

void print_process(const std::string& name, int grid, const std::string& results, const ProcessTime& time) {
  fmt::print("{:14} {:5} {:>9} {:>9.0f} {:>9.1f}\n", name, grid, results, time.cpu_ms, time.peak_mib);
  std::fflush(stdout);
}

// All that a user waits for: the process starts, reads, matches, and writes all its results or prints them as JSON.
void measure_processes(const Options& options) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("homolog_speed_{}", getpid());
  fmt::print("\nhomolog match as a process, one thread\n{:14} {:>5} {:>9} {:>9} {:>9}\n", "shape", "grid", "results", "CPU ms", "peak MiB");
  for (const auto& [model, data] : options.matching.pairs) {
    for (const int grid : options.matching.grids) {
      const std::string name = std::filesystem::path(model).stem().string(), voxels = std::to_string(grid);
      std::vector<std::string> words{options.program, "match", model, data, "--threads", "1", "--quiet", "--resolution", voxels, "--json"};
      print_process(name, grid, "JSON", measure_process(words, options.matching.repeats));
      words.back() = "--out";
      words.push_back(folder.string());
      print_process(name, grid, "files", measure_process(words, options.matching.repeats));
    }
  }
  std::filesystem::remove_all(folder);
}

void measure_speed(const Options& options) {
  const MachineFloor floor = measure_floor();
  fmt::print("{}\n", machine_and_commit());
  print_floor(floor);
  if (!options.program.empty()) {
    const ProcessTime start = measure_process({options.program, "--help"}, starts);
    fmt::print("start to the first line of --help: {:.1f} ms, {:.1f} CPU ms\n", start.first_line_ms, start.cpu_ms);
  }
  print_speed_header();
  for (const NamedMesh& shape : meshes_of(options)) measure_shape(shape, options.matching, floor);
  measure_whole_matches(options.matching, floor);
  measure_points(options.matching);
  measure_copies(options.matching);
  if (!options.program.empty()) measure_processes(options);
}

int run(int argc, char** argv) {
  CLI::App app{"Time and memory of every stage of describing and matching, beside the machine's floor"};
  Options options;
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  if (options.quick) options.matching = {{64, 128}, {1}, {30}, {1, 2}, options.matching.pairs, 1};
  measure_speed(options);
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
