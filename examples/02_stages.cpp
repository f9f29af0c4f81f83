// SPDX-License-Identifier: MIT
// The stages of describe_shape, each called alone: example_02_stages SHAPE [SLICE.pgm]
#include <homolog/describe/descriptors.h>
#include <homolog/salient/direction.h>
#include <homolog/salient/salient_points.h>
#include <homolog/shape/inside_tree.h>
#include <homolog/shape/read_mesh.h>
#include <homolog/shape/voxelize.h>

#include <fstream>
#include <iostream>

using namespace homolog;

namespace {

// The middle slice across the first axis as a grey picture: black is inside, white is outside.
void write_slice(const Interior& interior, const char* path) {
  const auto [x, y, z] = interior.frame.size;
  std::ofstream file(path, std::ios::binary);
  file << "P5 " << y << ' ' << z << " 255\n";
  for (int k = z - 1; k >= 0; --k) {
    for (int j = 0; j < y; ++j) file.put(static_cast<char>(255 - 255 * interior.at(x / 2, j, k)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) return 2;
  const Params params;

  const Mesh mesh = read_mesh(argv[1]);
  std::cout << mesh.vertices.size() << " vertices, " << mesh.triangles.size() << " triangles\n";

  // Sec. 4.2: the characteristic function, as the share of each voxel that is inside.
  // --8<-- [start:voxels]
  const Voxels voxels = voxelize(mesh, params.voxel.resolution);
  // --8<-- [end:voxels]
  const auto [x, y, z] = voxels.interior.frame.size;
  std::cout << x << " x " << y << " x " << z << " voxels, " << 100 * voxels.guessed << " % of the inside guessed\n";
  if (argc == 3) write_slice(voxels.interior, argv[2]);

  // Sec. 4.3: salient points, then their directions.
  // --8<-- [start:salient]
  std::vector<SalientPoint> points = find_salient_points(voxels.interior, params.salient);
  find_directions(voxels.interior, params.salient, points);
  // --8<-- [end:salient]
  std::cout << points.size() << " salient points\n";

  // Sec. 5.2: descriptors; how different are the two largest points?
  // --8<-- [start:descriptors]
  const Descriptors descriptors = compute_descriptors(voxels.interior, points, params.descriptor);
  if (points.size() > 1)
    std::cout << "descriptor distance " << descriptor_distance(descriptors[0], descriptors[1], params.descriptor.kind) << "\n";
  // --8<-- [end:descriptors]

  // Sec. 6.2.3: how far a place, the corner of the grid, is from the solid.
  std::cout << "the corner is " << InsideTree(voxels.interior).distance(0, 0, 0) << " away\n";
}
