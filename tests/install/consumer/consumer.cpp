#include <homolog/homolog.h>
#include <homolog/shape/read_mesh.h>

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const homolog::Params params = homolog::paper_preset();
  const auto model = homolog::describe_shape(homolog::read_mesh(argv[1]), params);
  const auto data = homolog::describe_shape(homolog::read_mesh(argv[2]), params);
  std::cout << homolog::match_shapes(model, data, params).matches.size() << " matches\n";
}
