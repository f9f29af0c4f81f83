// SPDX-License-Identifier: MIT
#include "homolog/shape/inflate.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  // memory is taken as bytes come, whatever a header promises
constexpr int either_header = 15 + 32;               // of gzip or zlib, with the largest window

struct Stream {
  z_stream z{};
  Stream() { inflateInit2(&z, either_header); }
  ~Stream() { inflateEnd(&z); }
};

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.size() > 2 && bytes[0] == '\x1f' && bytes[1] == '\x8b'; }

std::string inflate(std::string_view compressed, std::size_t wanted, const std::string& file) {
  Stream stream;
  std::string bytes;
  std::size_t taken = 0;
  while (bytes.size() < wanted) {
    const std::size_t room = std::min(piece, wanted - bytes.size()), given = std::min(piece, compressed.size() - taken);
    const std::size_t before = bytes.size();
    bytes.resize(before + room);
    stream.z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(compressed.data() + taken));
    stream.z.avail_in = static_cast<uInt>(given);
    stream.z.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
    stream.z.avail_out = static_cast<uInt>(room);
    const int result = ::inflate(&stream.z, Z_NO_FLUSH);
    taken += given - stream.z.avail_in;
    bytes.resize(before + room - stream.z.avail_out);
    if (result == Z_STREAM_END) {
      if (!is_gzip(compressed.substr(taken)) || inflateReset(&stream.z) != Z_OK) break;  // gzip files may follow each other in one
      continue;
    }
    if (result != Z_OK && !(result == Z_BUF_ERROR && bytes.size() > before)) {
      throw FileError(
          fmt::format("{}: the compressed data end or break off after {} bytes; the file is truncated or damaged", file, bytes.size()));
    }
  }
  return bytes;
}

}  // namespace homolog
