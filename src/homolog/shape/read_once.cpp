// SPDX-License-Identifier: MIT
#include "homolog/shape/read_once.h"

#include <assimp/MemoryIOWrapper.h>

#include "homolog/base/large_memory.h"

namespace homolog {
namespace {

struct Stream : Assimp::MemoryIOStream {
  explicit Stream(std::string_view given)
      : MemoryIOStream(reinterpret_cast<const std::uint8_t*>(given.data()), given.size()), content(given) {}

  std::size_t Read(void* to, std::size_t size, std::size_t count) override {
    const std::size_t read = MemoryIOStream::Read(to, size, count);
    if (read * size == content.size()) forget(content);
    return read;
  }

  std::string_view content;
};

}  // namespace

Assimp::IOStream* ReadOnce::Open(const char* name, const char*) { return Exists(name) ? new Stream(content) : nullptr; }

}  // namespace homolog
