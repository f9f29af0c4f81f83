// SPDX-License-Identifier: MIT
#include "described_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "homolog/shape/read_mesh.h"

namespace homolog::cli {

DescribedFile describe_file(const std::string& path, const std::optional<Box>& part, const Params& params, const Limits& limits,
                            Console& console) {
  const std::string name = std::filesystem::path(path).filename().string();
  console.stage(fmt::format("reading {}", name));
  DescribedFile file{read_mesh(path, limits.file), {}};
  console.watch().lap(fmt::format("reading {}", name), file.mesh.triangles.size(), "triangles");
  console.stage(fmt::format("describing {}", name));
  try {
    file.shape = describe_shape(file.mesh, params, part, &console.watch());
    check_points(file.shape, limits);
  } catch (const ShapeError& error) {
    throw ShapeError(fmt::format("cannot use '{}': {}", path, error.what()));
  }
  file.shape.name = name;
  if (file.shape.guessed > 0) console.warn(fmt::format("{} is open; {:.3g} % of the inside was guessed", name, 100 * file.shape.guessed));
  return file;
}

}  // namespace homolog::cli
