// SPDX-License-Identifier: MIT
// Two meshes in, corresponding points out: example_01_match MODEL DATA
#include <homolog/homolog.h>
#include <homolog/shape/read_mesh.h>

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const homolog::Shape model = homolog::describe_shape(homolog::read_mesh(argv[1]));
  const homolog::Shape data = homolog::describe_shape(homolog::read_mesh(argv[2]));
  for (const homolog::Match& match : homolog::match_shapes(model, data).matches) {
    std::cout << "a " << homolog::handedness_name(match.handedness) << " match, confidence " << match.confidence << ":\n";
    for (const homolog::Correspondence& pair : match.pairs) {
      std::cout << "  " << pair.model_point.position.transpose() << "  ->  " << pair.data_point.position.transpose() << "\n";
    }
  }
}
