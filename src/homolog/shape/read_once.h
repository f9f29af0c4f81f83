// SPDX-License-Identifier: MIT
// The one file that assimp may open. It copies what it reads, so that of large files two copies would stand in memory at its worst moment.
#pragma once

#include <assimp/DefaultIOSystem.h>

#include <string>
#include <string_view>

namespace homolog {

/// `content` under the name `file`; no other file is there, such as textures, which a scene names and which are none of its business.
/// Content that was read whole is forgotten, where the system can: it must not be used any more, so this belongs into a process of its own.
struct ReadOnce : Assimp::DefaultIOSystem {
  ReadOnce(std::string_view given, std::string name) : content(given), file(std::move(name)) {}
  bool Exists(const char* name) const override { return name == file; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;

  std::string_view content;
  std::string file;
};

}  // namespace homolog
