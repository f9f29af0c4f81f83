// SPDX-License-Identifier: MIT
#include "described_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <new>

#include "homolog/base/errors.h"
#include "homolog/shape/core_share.h"
#include "homolog/shape/read_mesh.h"

namespace homolog::cli {
namespace {

void warn_if_open(const Shape& shape, Console& console) {
  if (shape.open == 0) return;
  console.warn(fmt::format("{} is open ({:.3g} % of its edges, {} piece{}); {:.3g} % of the inside was guessed", shape.name,
                           100 * shape.open, shape.components, shape.components == 1 ? "" : "s", 100 * shape.guessed));
}

Mesh read_shape(const std::string& path, const Limits& limits, const Label& label, const Tell& tell) {
  try {
    return read_mesh(path, limits.file, label, tell);
  } catch (const std::bad_alloc&) {
    throw FileError(fmt::format("{}: not enough memory to read it; simplify or crop it, or allow more by --max-memory", path));
  }
}

}  // namespace

DescribedFile describe_file(const std::string& path, const std::optional<Box>& part, const Params& params, const Limits& limits,
                            Console& console, const Label& label) {
  const std::string name = std::filesystem::path(path).filename().string();
  console.stage(fmt::format("reading {}", name));
  DescribedFile file{read_shape(path, limits, label, warnings_of(path, console)), {}};
  console.watch().lap(fmt::format("reading {}", name), file.mesh.triangles.size(), "triangles");
  console.stage(fmt::format("describing {}", name));
  try {
    file.shape = describe_shape(file.mesh, params, part, &console.watch());
    check_points(file.shape, limits);
  } catch (const ShapeError& error) {
    throw ShapeError(fmt::format("cannot use '{}': {}", path, error.what()));
  } catch (const std::bad_alloc&) {
    throw ShapeError(
        fmt::format("{}: not enough memory to describe it; a lower --resolution needs less, and --max-memory may allow more", path));
  }
  file.shape.name = name;
  warn_if_open(file.shape, console);
  if (const std::string far = part ? "" : told_core(file.mesh); !far.empty()) console.warn(fmt::format("{}: {}", name, far));
  return file;
}

std::string no_points(const Shape& shape) {
  return fmt::format("nothing found: {} has no salient point; a lower --threshold or a higher --resolution may find some", shape.name);
}

}  // namespace homolog::cli
