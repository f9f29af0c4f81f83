// SPDX-License-Identifier: MIT
#include "homolog/homolog.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "homolog/base/parallel.h"
#include "homolog/describe/cut_faces.h"
#include "homolog/describe/separate_surfaces.h"
#include "homolog/describe/thickness.h"
#include "homolog/describe/turn_shape.h"
#include "homolog/match/axis_starts.h"
#include "homolog/match/candidates.h"
#include "homolog/match/clique_growth.h"
#include "homolog/match/end_starts.h"
#include "homolog/match/family.h"
#include "homolog/match/growth.h"
#include "homolog/match/region_starts.h"
#include "homolog/match/repeated_pieces.h"
#include "homolog/match/seeds.h"
#include "homolog/match/verify.h"
#include "homolog/salient/direction.h"
#include "homolog/salient/salient_points.h"
#include "homolog/shape/principal_axes.h"
#include "homolog/shape/voxelize.h"

namespace homolog {
namespace {

constexpr double least_extent = 1e-20, most_extent = 1e20;  // squares of lengths must be numbers in single precision, too
constexpr int surface_samples = 1600;
constexpr std::size_t body_samples = 400;
constexpr std::size_t many_pieces = 3;       // so many share the samples, of which there are as many times more
constexpr std::size_t repeated_pieces = 12;  // of a shape, that are looked for again in it
constexpr std::size_t sets_of_a_chirality = 24;
constexpr std::size_t axis_starts_of_a_chirality = 4;
constexpr std::size_t end_starts_of_a_chirality = 12;
constexpr std::size_t region_starts_of_a_chirality = 8;
constexpr std::size_t outward_starts_of_a_chirality = 12;

// Sec. 6.2.2: the distinct sets of one chirality that grow from the seeds.
std::vector<GrownSet> grow_seeds(const std::vector<Seed>& seeds, Chirality chirality, const CorrespondenceSet& candidates,
                                 const Shape& model, const Params& params) {
  std::vector<GrownSet> sets(seeds.size());
  parallel_for(seeds.size(), [&](std::size_t i) { sets[i] = grow_seed(seeds[i], chirality, candidates, model, params.match.bending); });
  return distinct_sets(std::move(sets), sets_of_a_chirality, model);
}

// And the starts that need no pairs.
std::vector<GrownSet> grow_all(const std::vector<Seed>& seeds, const CorrespondenceSet& candidates, const Shape& model, const Shape& data,
                               const Params& params) {
  const std::vector<FollowedEnds> ends = follow_ends(model, data);
  const std::vector<Region> regions = regions_to_lay_on(data.body);
  std::vector<GrownSet> sets;
  const auto add = [&](const std::vector<GrownSet>& some) { sets.insert(sets.end(), some.begin(), some.end()); };
  for (const Chirality chirality : {Chirality::proper, Chirality::mirrored}) {
    add(grow_seeds(seeds, chirality, candidates, model, params));
    add(axis_starts(model, data, chirality, axis_starts_of_a_chirality));
    add(end_starts(ends, model, data, chirality, end_starts_of_a_chirality));
    const double on_whole = distance_on_whole(model, data, chirality);  // what lies worse on a region is no part that lies there
    add(region_starts(regions, model, chirality, on_whole, region_starts_of_a_chirality));
    add(outward_starts(regions, model, data, chirality, on_whole, outward_starts_of_a_chirality));
  }
  return sets;
}

// Pairs as seeds, growth under the set's own spline, refinement as a cloth.
Family match_by_pairs(const Shape& model, const Shape& data, const Params& params, bool without_identity, Stopwatch* watch) {
  const CorrespondenceSet candidates = find_candidates(model, data, params);  // Sec. 6.2.1
  lap(watch, "candidates", candidates.size(), "candidates");
  const std::vector<Seed> seeds = find_seeds(candidates, model, data);
  lap(watch, "seeds", seeds.size(), "seeds");
  const std::vector<GrownSet> sets = grow_all(seeds, candidates, model, data, params);
  lap(watch, "growth", sets.size(), "grown sets");
  Family family = make_family(sets, model, data, params, without_identity, watch);  // Sec. 6.2.3
  measure_chamfer(family.matches, model, data);                                     // eq. 9
  lap(watch, "chamfer", family.matches.size(), "matches");
  family.counts.stages = {{"candidates", static_cast<long>(candidates.size())},
                          {"seeds", static_cast<long>(seeds.size())},
                          {"grown sets", static_cast<long>(sets.size())}};
  return family;
}

// The paper's way, to the letter where its equations allow.
Family match_by_quadruples(const Shape& model, const Shape& data, const Params& params, bool without_identity, Stopwatch* watch) {
  const CorrespondenceSet candidates = find_candidates(model, data, params);  // eq. 7
  lap(watch, "candidates", candidates.size(), "candidates");
  const GrownSets grown = grow_quadruples(candidates, model.diagonal, params.paper);  // App. A, B, Sec. 6.2.2
  lap(watch, "growth", grown.sets.size(), "grown sets");
  Family family;
  family.matches = verified_sets(grown.sets, model, data, params, without_identity);  // eq. 8, Sec. 6.2.3
  lap(watch, "verification", family.matches.size(), "matches");
  family.counts.stages = {{"candidates", static_cast<long>(candidates.size())},
                          {"quadruples", grown.quadruples},
                          {"grown sets", static_cast<long>(grown.sets.size())}};
  return family;
}

void check_alike(const Shape& model, const Shape& data) {
  if (model.descriptors.empty() || data.descriptors.empty() || model.descriptors[0].size() == data.descriptors[0].size()) return;
  throw ParamError("the shapes were described with descriptors of different lengths; describe both with the same parameters");
}

Family match_described(const Shape& model, const Shape& data, const Params& params, bool without_identity, Stopwatch* watch) {
  check(params);
  check_alike(model, data);
  const ThreadLimit limit(params.threads);
  const bool by_pairs = params.match.seeds == Seeds::pairs;
  Family family = (by_pairs ? match_by_pairs : match_by_quadruples)(model, data, params, without_identity, watch);
  auto& stages = family.counts.stages;
  stages.insert(stages.begin(), {"data points", static_cast<long>(data.points.size())});
  stages.insert(stages.begin(), {"model points", static_cast<long>(model.points.size())});
  stages.emplace_back("matches", static_cast<long>(family.matches.size()));
  return family;
}

void check_extent(const Mesh& mesh) {
  const Box box = bounding_box(mesh);
  const double extent = (box.max - box.min).maxCoeff();
  if (extent >= least_extent && extent <= most_extent) return;
  throw ShapeError(fmt::format("the shape has no extent, or one too small or too large for numbers ({:.2g}); scale it", extent));
}

// Samples of the skin, and the body that joins them.
void sample_skin(Shape& shape, int finer, const std::function<void()>& forget_cut, Stopwatch* watch) {
  shape.surface = sample_surface(shape.interior, finer * surface_samples);
  forget_cut();
  lap(watch, "surface samples", shape.surface.size(), "samples");
  shape.body = build_body(shape.interior, shape.surface, finer * body_samples, shape.points);
  lap(watch, "body", shape.body.nodes.size(), "nodes");
}

// All of Sec. 3 to 5 on the grid along the mesh's coordinates.
Shape describe_upright(const Mesh& mesh, const Params& params, const std::optional<Box>& part, Stopwatch* watch) {
  Shape shape;
  Voxels voxels = voxelize(mesh, params.voxel.resolution, part, params.voxel.thicken);  // Sec. 4.2
  shape.interior = std::move(voxels.interior);
  shape.guessed = voxels.guessed;
  shape.open = voxels.open;
  shape.components = voxels.components;
  const auto& frame = shape.interior.frame;
  shape.diagonal = frame.spacing * Vec3(frame.size[0] - 2, frame.size[1] - 2, frame.size[2] - 2).norm();
  lap(watch, "voxels", frame.voxels(), "voxels");
  shape.points = find_salient_points(shape.interior, params.salient);  // Sec. 4.3
  lap(watch, "salient points", shape.points.size(), "points");
  const auto forget_cut = [&] {
    if (!part) return;
    const Box whole = thickened_box(mesh, params.voxel.thicken);
    const Vec3 extent = whole.max - whole.min;
    const Box cut{whole.min + part->min.cwiseProduct(extent), whole.min + part->max.cwiseProduct(extent)};
    forget_cut_faces(cut, whole, frame.spacing, shape.points, shape.surface);
  };
  sample_skin(shape, 1, forget_cut, watch);
  const bool in_pieces = separate_surfaces(shape.surface, shape.body, many_pieces).size() == many_pieces;
  if (in_pieces) sample_skin(shape, many_pieces, forget_cut, watch);
  shape.thickness = thickness_at(shape.interior, shape.surface);
  shape.surface_spacing = typical_spacing(positions_of(shape.surface));
  find_directions(shape.interior, params.salient, shape.points);  // eq. 2, 3
  lap(watch, "directions", shape.points.size(), "points");
  shape.descriptors = compute_descriptors(shape.interior, shape.points, params.descriptor);  // Sec. 5.2
  lap(watch, "descriptors", shape.points.size(), "points");
  shape.ends = find_ends(shape.body);
  shape.inner_distance = inner_distances(shape.body, shape.interior);
  lap(watch, "ends", shape.ends.nodes.size(), "ends");
  return shape;
}

}  // namespace

Shape describe_shape(const Mesh& mesh, const Params& params, const std::optional<Box>& part, Stopwatch* watch) {
  check(params);
  check_mesh(mesh);
  check_extent(mesh);
  const ThreadLimit limit(params.threads);
  // A part is told by the file's axes; a whole is looked at along its own, so that it is the same however it was turned.
  const Mat3 axes = part ? Mat3(Mat3::Identity()) : principal_axes(mesh);
  Shape shape = describe_upright(turned(mesh, axes.transpose()), params, part, watch);
  turn_shape(shape, axes);
  shape.ras = mesh.ras;
  shape.surface_blocks = make_blocks(shape.surface);
  settle_body(shape.body);
  return shape;
}

Family match_shapes(const Shape& model, const Shape& data, const Params& params, Stopwatch* watch) {
  return match_described(model, data, params, false, watch);
}

Family find_symmetries(const Shape& shape, const Params& params, Stopwatch* watch) {
  Family family = match_described(shape, shape, params, true, watch);
  const std::vector<std::vector<int>> pieces = separate_surfaces(shape.surface, shape.body, repeated_pieces);
  if (pieces.empty()) return family;
  const ThreadLimit limit(params.threads);
  std::erase_if(family.matches, [&](const Match& match) { return !moves_all(match, pieces, shape); });
  const std::vector<Match> of_whole = family.matches;
  std::vector<char> repeats(shape.surface.size(), 0);  // samples that an earlier piece comes to lie on
  for (const std::vector<int>& samples : pieces) {
    if (2 * std::count_if(samples.begin(), samples.end(), [&](int i) { return repeats[i]; }) > std::ssize(samples)) continue;
    const Piece piece = piece_of(shape, samples);
    Family found = match_described(piece.shape, shape, params, true, nullptr);
    believe_exact(found.matches, piece.shape, shape);
    for (const Match& match : found.matches) mark_reached(match, piece.shape, shape, repeats);
    std::erase_if(found.matches, [&](const Match& match) { return is_known(match, piece.shape, of_whole); });
    add_matches(family, std::move(found), piece, shape);
    lap(watch, "a piece", samples.size(), "samples");
  }
  keep_surest(family, params.match.matches);
  family.counts.stages.back().second = static_cast<long>(family.matches.size());
  return family;
}

}  // namespace homolog
