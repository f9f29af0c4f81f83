// SPDX-License-Identifier: MIT
// glTF 2.0 (ISO/IEC 12113) as it lies in its files: the JSON, the buffers, and tables of numbers in them. Ours, because assimp
// forgets most of a material, knows no quantised positions and needs a fence; the JSON is nlohmann's.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "homolog/shape/attributes.h"

namespace homolog {

struct GltfFile {
  std::string name;  ///< for messages
  nlohmann::json document;
  std::vector<std::string> buffers;
};

/// A .glb, or a .gltf with its buffers inside or beside it. Throws FileError, also for extensions that it says are required and that change
/// where things lie.
GltfFile read_gltf_file(std::string_view content, const std::string& name, const FindOther& find_other);

/// Whether content begins as a .glb does.
bool is_glb(std::string_view content);

/// Throws FileError: "FILE: WHAT; the file is damaged, export it again".
[[noreturn]] void fail(const GltfFile& file, const std::string& what);

/// Throws FileError: that the file needs an extension, and what to do.
[[noreturn]] void refuse_extension(const GltfFile& file, const std::string& name);

/// Entry `number` of a list of the document, as "nodes". Throws FileError when it is not there.
const nlohmann::json& entry(const GltfFile& file, const char* list, std::size_t number);

/// A whole number from 0 on that an object names; none if it does not. Throws FileError for anything else.
std::optional<std::size_t> number_at(const GltfFile& file, const nlohmann::json& object, const char* key);

/// The numbers of a list that an object names, as "children"; empty if it does not. Throws FileError.
std::vector<std::size_t> numbers_at(const GltfFile& file, const nlohmann::json& object, const char* key);

/// `count` finite numbers, as of "translation"; none if the object does not name them. Throws FileError.
std::optional<std::vector<double>> floats_at(const GltfFile& file, const nlohmann::json& object, const char* key, std::size_t count);

/// A text of an object; empty if it names none.
std::string text_at(const nlohmann::json& object, const char* key);

/// The bytes of a part of a buffer. Throws FileError.
std::string_view buffer_view(const GltfFile& file, std::size_t number);

/// The bytes that a URI names: base64 inside itself, or a file beside; none if that is not there. Throws FileError.
std::optional<std::string> uri_bytes(const GltfFile& file, const std::string& uri, const FindOther& find_other);

/// "a b.png" of "a%20b.png".
std::string name_of_uri(const std::string& uri);

}  // namespace homolog
