// SPDX-License-Identifier: MIT
// The stages of match_shapes, each called alone, as CSV: a row for each pair of points that a stage lets through.
//   example_03_match_stages MODEL DATA
#include <homolog/homolog.h>
#include <homolog/match/candidates.h>
#include <homolog/match/family.h>
#include <homolog/match/growth.h>
#include <homolog/match/seeds.h>
#include <homolog/shape/read_mesh.h>

#include <iostream>

using namespace homolog;

namespace {

void print(const char* stage, const CorrespondenceSet& pairs) {
  const auto place = [](const Vec3& x) { std::cout << ',' << x.x() << ',' << x.y() << ',' << x.z(); };
  for (const Correspondence& pair : pairs) {
    std::cout << stage << ',' << pair.model << ',' << pair.data << ',' << pair.descriptor_distance;
    place(pair.model_point.position);
    place(pair.data_point.position);
    std::cout << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  // --8<-- [start:describe]
  const Params params;
  const Shape model = describe_shape(read_mesh(argv[1]), params);
  const Shape data = describe_shape(read_mesh(argv[2]), params);
  // --8<-- [end:describe]
  std::cout << "stage,model,data,distance,model_x,model_y,model_z,data_x,data_y,data_z\n";

  // --8<-- [start:seeds]
  const CorrespondenceSet candidates = find_candidates(model, data, params);
  const std::vector<Seed> seeds = find_seeds(candidates, model, data);  // best first
  // --8<-- [end:seeds]
  print("candidate", candidates);
  if (seeds.empty()) return 1;
  print("seed", seeds.front().pairs);

  // --8<-- [start:growth]
  std::vector<GrownSet> grown;
  for (const Seed& seed : seeds) grown.push_back(grow_seed(seed, Chirality::proper, candidates, model, params.match.bending));
  grown = distinct_sets(std::move(grown), 10, model);
  // --8<-- [end:growth]
  print("grown", grown.front().pairs);

  // --8<-- [start:family]
  const Family family = make_family(grown, model, data, params, false);
  // --8<-- [end:family]
  if (!family.matches.empty()) print("match", family.matches.front().pairs);
}
