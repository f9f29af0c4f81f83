// SPDX-License-Identifier: MIT
// Makes the pages that report_test.mjs opens, and the morphs and carried attributes that gltf_test.mjs judges: make_report DIR. The family
// is laid by hand over two animals made in code, so that the pages do not depend on what the algorithm finds.
#include <Eigen/Geometry>
#include <filesystem>

#include "fixtures/solids.h"
#include "homolog/match/carry_attributes.h"
#include "homolog/outputs/attributes_gltf.h"
#include "homolog/outputs/dense_files.h"
#include "homolog/outputs/morph.h"
#include "homolog/outputs/report.h"
#include "homolog/outputs/write_file.h"
#include "homolog/shape/gltf_file.h"
#include "homolog/shape/voxelize.h"

namespace {

using namespace homolog;

/// An animal as balls joined by limbs; the same number is the same place in every pose.
struct Animal {
  std::vector<SalientPoint> points;
  Mesh mesh;
};

const std::vector<std::pair<Vec3, double>> kBalls = {{{-0.5, 0, 0}, 0.3},        {{0.4, 0, 0.02}, 0.28},     {{0.75, 0, 0.35}, 0.16},
                                                     {{1, 0, 0.6}, 0.19},        {{1.3, 0, 0.52}, 0.11},     {{-0.9, 0, 0.1}, 0.09},
                                                     {{-1.3, 0, 0}, 0.06},       {{0.45, 0.2, -0.4}, 0.13},  {{0.45, 0.2, -0.85}, 0.1},
                                                     {{0.45, -0.2, -0.4}, 0.13}, {{0.45, -0.2, -0.85}, 0.1}, {{-0.5, 0.2, -0.4}, 0.14},
                                                     {{-0.55, 0.2, -0.85}, 0.1}, {{-0.5, -0.2, -0.4}, 0.14}, {{-0.55, -0.2, -0.85}, 0.1}};
constexpr int kLimbs[][2] = {{0, 1}, {1, 2}, {2, 3},  {3, 4},  {0, 5},   {5, 6},  {1, 7},
                             {7, 8}, {1, 9}, {9, 10}, {0, 11}, {11, 12}, {0, 13}, {13, 14}};

Animal make_animal(double bend, const Similarity& similarity) {
  Animal animal;
  std::vector<fixtures::Solid> solids;
  auto balls = kBalls;
  for (auto& [centre, radius] : balls) {
    centre.y() += bend * centre.x() * centre.x();
    solids.push_back(fixtures::ball(centre, radius));
    animal.points.push_back({similarity(centre), similarity.scale * radius, similarity.rotation * Vec3::UnitX(), 0.4, 0.9});
  }
  for (const auto& [a, b] : kLimbs) {
    solids.push_back(fixtures::capsule(balls[a].first, balls[b].first, 0.75 * std::min(balls[a].second, balls[b].second)));
  }
  animal.mesh = fixtures::mesh_of(fixtures::join(solids), 64);
  for (Vec3& v : animal.mesh.vertices) v = similarity(v);
  return animal;
}

Shape make_shape(const std::string& name, const Animal& animal) {
  Shape shape;
  shape.name = name;
  shape.diagonal = bounding_box(animal.mesh).diagonal();
  shape.points = animal.points;
  shape.interior = voxelize(animal.mesh, 64).interior;
  return shape;
}

/// Pairs point i with point partner(i) for the points from `first` to `last`.
template <class Partner>
Match make_match(const Animal& model, const Animal& data, int first, int last, Partner partner, Handedness handedness,
                 Kernel kernel = Kernel::r) {
  Match match;
  std::vector<Vec3> sources, targets;
  for (int i = first; i <= last; ++i) {
    const int j = partner(i);
    match.pairs.push_back({i, j, model.points[i], data.points[j], 0.1 + 0.02 * i, 1 - 0.06 * (i - first)});
    sources.push_back(model.points[i].position);
    targets.push_back(data.points[j].position);
  }
  const Chirality chirality = handedness == Handedness::mirrored ? Chirality::mirrored : Chirality::proper;
  const std::vector<double> exact(sources.size(), 0.0);
  const ThinPlateSpline spline = ThinPlateSpline::similarity_free(SourceSystem(sources, exact), targets, chirality);
  match.data_from_model = kernel == Kernel::r ? spline : ThinPlateSpline::affine_free(sources, targets);
  match.similarity = spline.similarity;
  match.handedness = handedness;
  match.confidence = 0.97 - 0.1 * first;
  match.bending = 0.02;
  match.chamfer = 0.006;
  match.model_coverage = match.data_coverage = (last - first + 1) / 15.0;
  return match;
}

Family make_family(const Animal& model, const Animal& data) {
  const auto same = [](int i) { return i; };
  const auto other_side = [](int i) { return i < 7 ? i : i + ((i - 7) % 4 < 2 ? 2 : -2); };
  Family family;
  family.matches = {make_match(model, data, 0, 14, same, Handedness::proper),
                    make_match(model, data, 0, 14, other_side, Handedness::mirrored, Kernel::r3),
                    make_match(model, data, 1, 4, same, Handedness::ambiguous)};
  family.counts.stages = {{"candidates", 225}, {"seeds", 40}, {"grown", 3}};
  return family;
}

/// Two by two pixels.
constexpr const char* kPicture =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAEklEQVR4nGP4"
    "z8DAAMIM/4EAAB/uBfsL2WiLAAAAAElFTkSuQmCC";

/// Materials that a glTF says more of: metal whose picture is turned, and bumps that are cut out.
constexpr const char* kMaterials = R"({"materials": [
  {"name": "metal", "pbrMetallicRoughness": {"roughnessFactor": 0.2, "metallicRoughnessTexture":
    {"index": 1, "extensions": {"KHR_texture_transform": {"rotation": 0.5}}}}},
  {"name": "bumps", "normalTexture": {"index": 0}, "alphaMode": "MASK", "occlusionTexture": {"index": 1}}],
  "textures": [{"source": 0, "sampler": 0}, {"source": 0}], "samplers": [{"wrapS": 33071}],
  "extensionsRequired": ["KHR_texture_transform"]})";

/// An animal with a bone from its middle to either end, a head that can be raised, colours, and two UV islands, one of them with a picture.
AttributedMesh dressed(const Mesh& mesh) {
  AttributedMesh animal;
  animal.mesh = mesh;
  animal.rig.joints = {{"pelvis", -1, Mat4::Identity()}, {"neck", 0, Mat4::Identity()}, {"tail", 0, Mat4::Identity()}};
  animal.rig.joints[1].bind(0, 3) = 0.6;
  animal.rig.joints[2].bind(0, 3) = -0.7;
  animal.shape_keys = {{"nod", 0.5, {}}};
  const Pose pelvis, neck = pose_of(local_bind(animal.rig, 1)), tail = pose_of(local_bind(animal.rig, 2)),
                     raised{neck.shift, Eigen::Quaterniond(Eigen::AngleAxisd(0.4, Vec3::UnitY())), neck.scale};
  animal.animations = {{"graze", {0, 1, 2}, {{pelvis, pelvis, pelvis}, {neck, raised, neck}, {tail, tail, tail}}, {{0.5, 0, 0.5}}}};
  for (const Vec3& x : mesh.vertices) {
    const auto front = static_cast<float>(std::clamp(2 * x.x() - 0.7, 0.0, 1.0)),
               back = static_cast<float>(std::clamp(-2 * x.x() - 0.9, 0.0, 1.0));
    animal.rig.influences.push_back(strongest_influences({{0, 1 - front - back}, {1, front}, {2, back}}));
    animal.shape_keys[0].displacements.push_back(std::max(0.0, x.x() - 0.7) * Vec3(0, 0, -0.5));
    animal.colours.push_back({1, front, back, 1});
    for (const double u : {0.3, 0.7}) animal.texturing.uvs.push_back({u + x.x() / 10, 0.5 + x.z() / 4});
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t left = mesh.vertices[a].y() + mesh.vertices[b].y() + mesh.vertices[c].y() > 0;
    animal.texturing.corners.push_back({2 * a + left, 2 * b + left, 2 * c + left});
    animal.texturing.material_of.push_back(static_cast<int>(left));
  }
  animal.texturing.materials = {{"plain", {0.5f, 0.4f, 0.3f, 0.5f}, -1}, {"painted", {1, 1, 1, 1}, 0}};
  const GltfFile none{"", {}, {}};
  animal.texturing.images = {{"picture.png", uri_bytes(none, kPicture, {}).value()}};
  return animal;
}

/// The same with a vertex that follows five joints, more than one set of weights can hold.
Rig with_toes(Rig rig) {
  rig.joints.resize(5, rig.joints[2]);
  rig.influences[0] = strongest_influences({{0, 5}, {1, 4}, {2, 3}, {3, 2}, {4, 1}}, 8);
  return rig;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const Similarity turn{1.4, Eigen::AngleAxisd(2.2, Vec3(1, 2, 0.5).normalized()).toRotationMatrix(), {1000, 20, 3}};
  const Animal model = make_animal(0, {}), data = make_animal(0.25, turn);
  const Family family = make_family(model, data);
  const Family nothing{{}, {{{"candidates", 12}, {"seeds", 0}}}};
  const Shape a = make_shape("deer.off", model), b = make_shape("bent deer.off", data);
  const Shape hostile = make_shape("</script><script>alert(1)</script><img src=x onerror=alert(2)>.off", model);
  const MeshedShape left{model.mesh, a}, right{data.mesh, b};
  const std::vector<MatchParts> parts = covered_parts(left, right, family.matches);
  write_file(folder / "match.html", match_report(left, right, family, parts, {}));
  Family doubtful = family;
  for (Match& match : doubtful.matches) match.confidence *= 0.4;
  write_file(folder / "doubtful.html", match_report(left, right, doubtful, parts, {}));
  write_file(folder / "empty.html", match_report(left, right, nothing, {}, {}));
  write_file(folder / "points.html", points_report(left, {}));
  write_file(folder / "hostile.html", match_report({model.mesh, hostile}, right, family, parts, {}));
  const Family itself = make_family(model, model);
  const std::vector<Symmetry> symmetries = {{{}, itself.matches[0].similarity, 0.3}, {Plane{Vec3::UnitY(), 0}, {}, 0.0012}, {}};
  write_file(folder / "symmetry.html", match_report(left, left, itself, covered_parts(left, left, itself.matches), {}, symmetries));
  const MatchMap map = match_maps(family.matches, a, b, parts).front();
  const Morph morph = make_morph(map, model.mesh, dense_maps(map, model.mesh, data.mesh));
  write_file(folder / "morph.glb", morph_glb(morph, {}));
  write_file(folder / "coloured.glb", morph_glb(morph, position_colours(model.mesh)));
  const DenseMap places = dense_maps(map, model.mesh, data.mesh).model_from_data;
  AttributedMesh animal = dressed(model.mesh), carried = carry_attributes(animal, data.mesh, places.places, chirality_of(map));
  write_files(attributes_gltf(carried, folder / "carried.glb", "deer"));
  animal.texturing.gltf = kMaterials;
  carried = carry_attributes(animal, data.mesh, places.places, chirality_of(map));
  carried.rig = with_toes(carried.rig);
  carried.animations.clear();
  write_files(attributes_gltf(carried, folder / "carried too.gltf", "deer"));
}
