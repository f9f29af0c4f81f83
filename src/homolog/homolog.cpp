// SPDX-License-Identifier: MIT
#include "homolog/homolog.h"

#include "homolog/base/parallel.h"
#include "homolog/match/candidates.h"
#include "homolog/match/family.h"
#include "homolog/match/growth.h"
#include "homolog/match/seeds.h"
#include "homolog/salient/direction.h"
#include "homolog/salient/salient_points.h"
#include "homolog/shape/voxelize.h"

namespace homolog {
namespace {

constexpr int surface_samples = 1600;
constexpr std::size_t body_samples = 400;
constexpr std::size_t sets_of_a_chirality = 10;

std::vector<GrownSet> grow_all(const std::vector<Seed>& seeds, Chirality chirality, const CorrespondenceSet& candidates, const Shape& model,
                               const Shape& data, const Params& params) {
  std::vector<GrownSet> sets(seeds.size());
  parallel_for(seeds.size(),
               [&](std::size_t i) { sets[i] = grow_seed(seeds[i], chirality, candidates, model, data, params.match.bending); });
  return distinct_sets(std::move(sets), sets_of_a_chirality);
}

Family match_described(const Shape& model, const Shape& data, const Params& params, bool without_identity) {
  check(params);
  const ThreadLimit limit(params.threads);
  const CorrespondenceSet candidates = find_candidates(model, data, params);                         // Sec. 6.2.1
  const std::vector<Seed> seeds = find_seeds(candidates, model, data);                               // App. A, B
  std::vector<GrownSet> sets = grow_all(seeds, Chirality::proper, candidates, model, data, params);  // Sec. 6.2.2
  const std::vector<GrownSet> mirrored = grow_all(seeds, Chirality::mirrored, candidates, model, data, params);
  sets.insert(sets.end(), mirrored.begin(), mirrored.end());
  Family family = make_family(sets, model, data, params, without_identity);  // Sec. 6.2.3
  family.counts.stages = {{"model points", static_cast<long>(model.points.size())}, {"data points", static_cast<long>(data.points.size())},
                          {"candidates", static_cast<long>(candidates.size())},     {"seeds", static_cast<long>(seeds.size())},
                          {"grown sets", static_cast<long>(sets.size())},           {"matches", static_cast<long>(family.matches.size())}};
  return family;
}

}  // namespace

Shape describe_shape(const Mesh& mesh, const Params& params, const std::optional<Box>& part) {
  check(params);
  const ThreadLimit limit(params.threads);
  Shape shape;
  Voxels voxels = voxelize(mesh, params.voxel.resolution, part);  // Sec. 4.2
  shape.interior = std::move(voxels.interior);
  shape.guessed = voxels.guessed;
  const auto& frame = shape.interior.frame;
  shape.diagonal = frame.spacing * Vec3(frame.size[0] - 2, frame.size[1] - 2, frame.size[2] - 2).norm();
  shape.points = find_salient_points(shape.interior, params.salient);                        // Sec. 4.3
  find_directions(shape.interior, params.salient, shape.points);                             // eq. 2, 3
  shape.descriptors = compute_descriptors(shape.interior, shape.points, params.descriptor);  // Sec. 5.2
  shape.surface = sample_surface(shape.interior, surface_samples);
  shape.body = build_body(shape.interior, shape.surface, body_samples, shape.points);
  shape.inner_distance = inner_distances(shape.body, shape.interior);
  return shape;
}

Family match_shapes(const Shape& model, const Shape& data, const Params& params) { return match_described(model, data, params, false); }

Family find_symmetries(const Shape& shape, const Params& params) { return match_described(shape, shape, params, true); }

}  // namespace homolog
