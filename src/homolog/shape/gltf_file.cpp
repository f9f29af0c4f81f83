// SPDX-License-Identifier: MIT
#include "homolog/shape/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "homolog/base/errors.h"
#include "homolog/shape/base64.h"
#include "homolog/shape/json_fault.h"
#include "homolog/shape/text.h"

namespace homolog {
namespace {

using nlohmann::json;

constexpr int deepest = 64;  // nesting of the JSON

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (int k = 3; k >= 0; --k) word = word << 8 | static_cast<unsigned char>(bytes[at + k]);
  return word;
}

/// The two parts of a .glb.
struct Chunks {
  std::string_view json, binary;
};

Chunks chunks_of(std::string_view content, const GltfFile& file) {
  if (content.size() < 20 || word_at(content, 4) != 2) fail(file, "it is not glTF 2.0");
  Chunks chunks;
  std::string_view rest = content.substr(12);
  while (rest.size() >= 8) {
    const std::size_t length = word_at(rest, 0);
    const std::string_view type = rest.substr(4, 4);
    if (length > rest.size() - 8) fail(file, "a part of it is longer than the file");
    if (type == "JSON" && chunks.json.empty()) chunks.json = rest.substr(8, length);
    if (type == std::string_view("BIN\0", 4) && chunks.binary.empty()) chunks.binary = rest.substr(8, length);
    rest.remove_prefix(8 + length);
  }
  return chunks;
}

json parse(std::string_view text, const GltfFile& file) {
  const auto limit = [&](int depth, json::parse_event_t, json&) {
    if (depth > deepest) fail(file, "its JSON is nested too deeply");
    return true;
  };
  try {
    json document = json::parse(text, limit);
    if (!document.is_object()) fail(file, "its JSON is no object");
    return document;
  } catch (const json::exception& error) {
    fail(file, json_fault(error, text));
  }
}

/// Without which the triangles are what they are with it, or which is read (quantised positions).
bool can_be_left_out(std::string_view extension) {
  for (const char* harmless : {"KHR_mesh_quantization", "KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_",
                               "EXT_lights_", "KHR_animation_pointer", "KHR_xmp", "KHR_techniques_webgl"}) {
    if (extension.starts_with(harmless)) return true;
  }
  return false;
}

void check_extensions(const GltfFile& file) {
  const auto required = file.document.find("extensionsRequired");
  if (required == file.document.end() || !required->is_array()) return;
  for (const json& entry : *required) {
    const std::string name = entry.is_string() ? entry.get<std::string>() : std::string();
    if (!can_be_left_out(name)) refuse_extension(file, name);
  }
}

void check_version(const GltfFile& file) {
  const auto asset = file.document.find("asset");
  const std::string version = asset == file.document.end() ? "" : text_at(*asset, "version");
  if (!version.empty() && version[0] != '2') fail(file, "it is not glTF 2.0");
}

std::string decoded_base64(std::string_view text, const GltfFile& file) {
  std::string bytes;
  if (!decode_base64(text, std::string::npos, bytes)) fail(file, "data inside it is not base64");
  return bytes;
}

/// A buffer without a file may only stand for what compressed data would give (EXT_meshopt_compression).
void refuse_compressed(const GltfFile& file, const json& buffer) {
  const auto extensions = buffer.find("extensions");
  if (extensions == buffer.end() || !extensions->is_object()) return;
  for (const auto& [name, value] : extensions->items()) {
    if (name.ends_with("_compression")) refuse_extension(file, name);
  }
}

void read_buffers(GltfFile& file, std::string_view binary, const FindOther& find_other) {
  const auto list = file.document.find("buffers");
  if (list == file.document.end() || !list->is_array()) return;
  for (const json& buffer : *list) {
    const std::string uri = text_at(buffer, "uri");
    if (uri.empty()) refuse_compressed(file, buffer);
    const auto bytes = uri.empty() && file.buffers.empty() ? std::optional(std::string(binary)) : uri_bytes(file, uri, find_other);
    if (!bytes) {
      throw FileError(
          fmt::format("{}: it names the file '{}', which is not there; put the two together", file.name, shown(name_of_uri(uri), 100)));
    }
    if (number_at(file, buffer, "byteLength").value_or(0) > bytes->size()) fail(file, "a buffer is longer than its data");
    file.buffers.push_back(*bytes);
  }
}

}  // namespace

void refuse_extension(const GltfFile& file, const std::string& name) {
  if (name.ends_with("_compression")) {
    throw FileError(
        fmt::format("{}: its meshes are compressed ({}), which is not read; export it without compression", file.name, shown(name)));
  }
  throw FileError(fmt::format("{}: it needs the extension '{}', which is not read; export it without", file.name, shown(name)));
}

void fail(const GltfFile& file, const std::string& what) {
  throw FileError(fmt::format("{}: {}; the file is damaged, export it again", file.name, what));
}

bool is_glb(std::string_view content) { return content.substr(0, 4) == "glTF"; }

GltfFile read_gltf_file(std::string_view content, const std::string& name, const FindOther& find_other) {
  GltfFile file{name, {}, {}};
  const Chunks chunks = is_glb(content) ? chunks_of(content, file) : Chunks{content, {}};
  file.document = parse(chunks.json, file);
  check_version(file);
  check_extensions(file);
  read_buffers(file, chunks.binary, find_other);
  return file;
}

const json& entry(const GltfFile& file, const char* list, std::size_t number) {
  const auto found = file.document.find(list);
  if (found == file.document.end() || !found->is_array() || number >= found->size()) {
    fail(file, fmt::format("number {} of its {} does not exist", number, list));
  }
  return (*found)[number];
}

std::optional<std::size_t> number_at(const GltfFile& file, const json& object, const char* key) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  if (!found->is_number_unsigned()) fail(file, fmt::format("'{}' is not a whole number from 0 on", key));
  return found->get<std::size_t>();
}

std::vector<std::size_t> numbers_at(const GltfFile& file, const json& object, const char* key) {
  std::vector<std::size_t> numbers;
  const auto found = object.find(key);
  if (found == object.end()) return numbers;
  if (!found->is_array()) fail(file, fmt::format("'{}' is not a list", key));
  for (const json& number : *found) {
    if (!number.is_number_unsigned()) fail(file, fmt::format("'{}' holds what is not a whole number from 0 on", key));
    numbers.push_back(number.get<std::size_t>());
  }
  return numbers;
}

std::optional<std::vector<double>> floats_at(const GltfFile& file, const json& object, const char* key, std::size_t count) {
  const auto found = object.find(key);
  if (found == object.end()) return {};
  std::vector<double> values;
  for (const json& value : *found) values.push_back(value.is_number() ? value.get<double>() : NAN);
  const bool finite = std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  if (values.size() != count || !finite) fail(file, fmt::format("'{}' is not {} finite numbers", key, count));
  return values;
}

std::string text_at(const json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::string_view buffer_view(const GltfFile& file, std::size_t number) {
  const json& view = entry(file, "bufferViews", number);
  const std::size_t buffer = number_at(file, view, "buffer").value_or(file.buffers.size());
  const std::size_t offset = number_at(file, view, "byteOffset").value_or(0), length = number_at(file, view, "byteLength").value_or(0);
  if (buffer >= file.buffers.size()) fail(file, fmt::format("the buffer of view {} does not exist", number));
  const std::string_view bytes = file.buffers[buffer];
  if (offset > bytes.size() || length > bytes.size() - offset) fail(file, fmt::format("view {} reaches beyond its buffer", number));
  return bytes.substr(offset, length);
}

std::optional<std::string> uri_bytes(const GltfFile& file, const std::string& uri, const FindOther& find_other) {
  if (uri.compare(0, 5, "data:") != 0) return uri.empty() ? std::nullopt : find_other(name_of_uri(uri));
  const std::size_t comma = uri.find(',');
  if (comma == uri.npos || uri.substr(0, comma).find(";base64") == uri.npos) fail(file, "data inside it is not base64");
  return decoded_base64(std::string_view(uri).substr(comma + 1), file);
}

std::string name_of_uri(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) &&
                       std::isxdigit(static_cast<unsigned char>(uri[i + 2]));
    name += coded ? static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16)) : uri[i];
    if (coded) i += 2;
  }
  return name;
}

}  // namespace homolog
