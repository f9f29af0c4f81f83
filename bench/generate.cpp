// SPDX-License-Identifier: MIT
#include "generate.h"

#include <fmt/format.h>

#include <memory>
#include <set>

#include "change_mesh.h"
#include "cut_mesh.h"
#include "homolog/base/errors.h"
#include "mirror_symmetry.h"
#include "other_forms.h"
#include "random.h"
#include "scene.h"

namespace homolog::bench {
namespace {

using Truths = std::vector<TruePoints>;

// A mesh with what its cases need to know of it.
struct Source {
  std::string name;
  Mesh mesh;
  std::vector<int> swap;  ///< left-right partner of every vertex; empty without a symmetry
};

ShapeSource shape(const std::string& name, Mesh mesh) {
  return {name, [mesh = std::make_shared<const Mesh>(std::move(mesh))] { return *mesh; }};
}

// Vertex `numbers[i]` of the source is at model[i], and at places[numbers[i]] in the data.
TruePoints truth_of(const Source& source, const std::vector<int>& numbers, const std::vector<Vec3>& model,
                    const std::vector<Vec3>& places) {
  TruePoints points;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto vertex = static_cast<std::size_t>(numbers[i]);
    points.model.push_back(model[i]);
    points.data.push_back(places[vertex]);
    if (!source.swap.empty()) points.swapped_data.push_back(places[static_cast<std::size_t>(source.swap[vertex])]);
  }
  return points;
}

std::vector<int> all_numbers(const Mesh& mesh) {
  std::vector<int> numbers(mesh.vertices.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<int>(i);
  return numbers;
}

Case make_case(const std::string& task, const std::string& kind, const Source& source, ShapeSource model, ShapeSource data, Truths truths) {
  const PairEntry pair{task, kind + "/" + source.name, data.name, "generated"};
  return {pair, std::move(model), std::move(data), [truths = std::move(truths)](const Mesh&, const Mesh&) { return truths; }};
}

// The whole against the whole changed; `data` may have other vertices than the changed places.
Case changed_case(const std::string& kind, const Source& source, Mesh data, const std::vector<Vec3>& places) {
  TruePoints truth = truth_of(source, all_numbers(source.mesh), source.mesh.vertices, places);
  truth.mirrored = kind == "mirrored";
  return make_case(truth.mirrored ? "mirror" : "whole", kind, source, shape(source.name, source.mesh),
                   shape(source.name + "~" + kind, std::move(data)), {std::move(truth)});
}

Case changed_case(const std::string& kind, const Source& source, const Mesh& data) {
  return changed_case(kind, source, data, data.vertices);
}

void add_changed(std::vector<Case>& cases, const Source& source, std::uint64_t seed) {
  const Mesh& mesh = source.mesh;
  cases.push_back(changed_case("same", source, mesh));
  cases.push_back(changed_case("bent30", source, bent(mesh, 30)));
  cases.push_back(changed_case("bent60", source, bent(mesh, 60)));
  cases.push_back(changed_case("twisted60", source, twisted(mesh, 60)));
  cases.push_back(changed_case("lengthened", source, lengthened(mesh, 0.6, 1.6)));
  cases.push_back(changed_case("fattened", source, fattened(mesh, 1.5)));
  cases.push_back(changed_case("mirrored", source, mirrored(mesh)));
  cases.push_back(changed_case("noisy", source, noisy(mesh, 0.003, seed), mesh.vertices));
  cases.push_back(changed_case("clustered", source, clustered(mesh, 48), mesh.vertices));
  cases.push_back(changed_case("remeshed", source, remeshed(mesh), mesh.vertices));
}

// The vertices of `whole`, which is the source changed, are the source's.
Case part_case(const std::string& kind, const Source& source, const CutPart& part, const std::string& change, const Mesh& whole) {
  return make_case("part", kind, source, shape(source.name + "~" + kind, part.mesh), shape(source.name + "~" + change, whole),
                   {truth_of(source, part.whole_vertex, part.mesh.vertices, whole.vertices)});
}

// Parts of 10 to 60 % in the bent whole, one of 45 % in the whole as it is, and the whole in what is left when a piece is missing.
void add_cut(std::vector<Case>& cases, const Source& source, std::uint64_t seed) {
  Random random(seed, source.name + " cut");
  const Mesh data = bent(source.mesh, 30);
  for (const int percent : {10, 35, 60}) {
    const CutPart part = cut_share(source.mesh, random.direction(), percent / 100.0);
    cases.push_back(part_case(fmt::format("part{}", percent), source, part, "bent30", data));
  }
  const CutPart half = cut_share(source.mesh, Random(seed, source.name + " itself").direction(), 0.45);
  cases.push_back(part_case("part_in_itself", source, half, "same", source.mesh));
  const CutPart rest = cut_share(source.mesh, random.direction(), 0.7);
  const TruePoints truth = truth_of(source, rest.whole_vertex, rest.mesh.vertices, source.mesh.vertices);
  cases.push_back(
      make_case("whole", "piece_missing", source, shape(source.name, source.mesh), shape(source.name + "~rest", rest.mesh), {truth}));
}

Case scene_case(const std::string& kind, const Source& source, const std::vector<Mesh>& clutter, const SceneOptions& options,
                std::uint64_t seed) {
  const Scene scene = make_scene(source.mesh, clutter, options, seed);
  Truths truths;
  for (const Scene::Copy& copy : scene.copies) {
    const auto first = scene.mesh.vertices.begin() + static_cast<long>(copy.first_vertex);
    const std::vector<Vec3> places(first, first + static_cast<long>(source.mesh.vertices.size()));
    truths.push_back(truth_of(source, all_numbers(source.mesh), source.mesh.vertices, places));
    truths.back().mirrored = copy.mirrored;
  }
  return make_case("scene", kind, source, shape(source.name, source.mesh), shape(source.name + "~" + kind, scene.mesh), std::move(truths));
}

void add_scenes(std::vector<Case>& cases, const Source& source, const std::vector<Mesh>& clutter, std::uint64_t seed) {
  cases.push_back(scene_case("scene2", source, clutter, {.copies = 2, .largest_ratio = 1.3}, seed));
  cases.push_back(scene_case("scene3_mirrored", source, clutter, {.copies = 3, .largest_ratio = 1.5, .mirror = true}, seed + 1));
  cases.push_back(scene_case("scene3_bent", source, clutter, {.copies = 3, .largest_ratio = 2, .bend_degrees = 30}, seed + 2));
}

void check_names(const std::vector<NamedMesh>& meshes, const std::vector<NamedMesh>& strangers) {
  std::set<std::string> names;
  for (const auto* list : {&meshes, &strangers}) {
    for (const NamedMesh& named : *list) {
      if (names.insert(named.name).second) continue;
      throw ParamError(fmt::format("two meshes are named {}: rename the file, other than all given and made in code", named.name));
    }
  }
}

Source source_of(const NamedMesh& named) {
  if (!is_closed(named.mesh)) {
    throw ShapeError(fmt::format("{}: the mesh is not closed, so no share of it can be cut; close it, or leave it out", named.name));
  }
  Source source{named.name, named.mesh, mirror_symmetry(named.mesh.vertices, named.mesh.vertices.size())};
  if (volume_of(source.mesh) < 0) turn_over(source.mesh.triangles);
  return source;
}

}  // namespace

std::vector<Case> generated_cases(const std::vector<NamedMesh>& meshes, const std::vector<NamedMesh>& strangers, std::uint64_t seed) {
  check_names(meshes, strangers);
  std::vector<Mesh> clutter;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, strangers.size()); ++i) clutter.push_back(strangers[i].mesh);
  std::vector<Case> cases;
  for (const NamedMesh& named : meshes) {
    const Source source = source_of(named);
    add_changed(cases, source, seed);
    add_cut(cases, source, seed);
    add_scenes(cases, source, clutter, seed);
    for (const NamedMesh& stranger : strangers) {
      cases.push_back(make_case(unrelated, "unrelated", source, shape(source.name, source.mesh), shape(stranger.name, stranger.mesh), {}));
    }
  }
  return cases;
}

}  // namespace homolog::bench
