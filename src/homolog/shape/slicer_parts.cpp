// SPDX-License-Identifier: MIT
#include "homolog/shape/slicer_parts.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"
#include "homolog/shape/xml.h"

namespace homolog {
namespace {

std::size_t number(const XmlElement& element, std::string_view key, const std::string& file) {
  std::string_view word = element.attribute(key);
  Text text{file, {}, element.line};
  const long long value = take_integer(text, word, "a triangle's number");
  if (value < 0) fail(text, "a triangle's number is below 0; the file is damaged");
  return static_cast<std::size_t>(value);
}

/// Newer versions name the kind of a volume, older ones say that it modifies.
bool says_no_solid(const XmlElement& metadata) {
  const std::string_view key = metadata.attribute("key"), value = metadata.attribute("value");
  return (key == "volume_type" && value != "ModelPart") || (key == "modifier" && value == "1");
}

}  // namespace

std::map<std::string, std::vector<TriangleRange>> no_solid_parts(const ZipArchive& archive, const std::string& file, std::uint64_t most) {
  std::map<std::string, std::vector<TriangleRange>> parts;
  const std::optional<std::string> config = archive.read("Metadata/Slic3r_PE_model.config", most);
  if (!config) return parts;
  std::string object;
  std::optional<TriangleRange> volume;
  read_xml(*config, file, {[&](const XmlElement& element) {
    if (element.name == "object") object = element.attribute("id");
    if (element.name == "volume") volume = {number(element, "firstid", file), number(element, "lastid", file)};
    if (element.name == "metadata" && volume && says_no_solid(element)) {
      parts[object].push_back(*volume);
      volume.reset();
    }
    return true;
  }});
  return parts;
}

void leave_out(Mesh& mesh, const std::vector<TriangleRange>& parts, const std::string& file) {
  std::vector<long> changes(mesh.triangles.size() + 1);  // of the number of parts that a triangle is in, from the one before it
  for (const auto& [from, to] : parts) {
    if (from > to || to >= mesh.triangles.size())
      throw FileError(fmt::format("{}: its slicer's parts do not fit its triangles; the file is damaged, export it again", file));
    ++changes[from];
    --changes[to + 1];
  }
  std::vector<Triangle> kept;
  long within = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    within += changes[t];
    if (within == 0) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = std::move(kept);
}

}  // namespace homolog
