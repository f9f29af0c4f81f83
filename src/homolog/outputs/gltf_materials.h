// SPDX-License-Identifier: MIT
// Materials and pictures as glTF 2.0.
#pragma once

#include "homolog/outputs/glb.h"
#include "homolog/shape/texturing.h"

namespace homolog {

/// "materials", "textures", "samplers", "images", "extensionsUsed" and "extensionsRequired" of a document, those that it needs; the
/// pictures go into the content.
nlohmann::ordered_json gltf_materials(const Texturing& texturing, GltfContent& content);

/// Whether materials of a glTF file say more than a name, a base colour and its picture, which is all that other files hold.
bool says_more_than_base_colour(const Texturing& texturing);

/// "image/png" and the like; empty for other bytes.
std::string picture_type(const std::string& bytes);

/// "a%20b.png" of "a b.png".
std::string uri_of_name(const std::string& name);

}  // namespace homolog
