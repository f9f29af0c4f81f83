// SPDX-License-Identifier: MIT
#include "homolog/shape/zip_archive.h"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "homolog/base/errors.h"
#include "homolog/shape/text.h"

namespace homolog {

struct ZipArchive::Stream {
  std::string_view content;
  ZPOS64_T place = 0;
};

namespace {

constexpr int any_case = 2;
constexpr std::size_t piece = std::size_t{1} << 16;  // memory is taken as bytes come, whatever a header promises

template <class Stream>
zlib_filefunc64_def functions_of(Stream& stream) {
  zlib_filefunc64_def functions{};
  functions.opaque = &stream;
  functions.zopen64_file = [](void* opaque, const void*, int) { return opaque; };
  functions.zread_file = [](void*, void* opened, void* buffer, uLong size) -> uLong {
    auto& from = *static_cast<Stream*>(opened);
    const std::string_view bytes = from.content.substr(std::min<std::size_t>(from.place, from.content.size()), size);
    std::memcpy(buffer, bytes.data(), bytes.size());
    from.place += bytes.size();
    return bytes.size();
  };
  functions.ztell64_file = [](void*, void* opened) { return static_cast<Stream*>(opened)->place; };
  functions.zseek64_file = [](void*, void* opened, ZPOS64_T offset, int origin) -> long {
    auto& from = *static_cast<Stream*>(opened);
    const ZPOS64_T base = origin == ZLIB_FILEFUNC_SEEK_SET ? 0 : origin == ZLIB_FILEFUNC_SEEK_CUR ? from.place : from.content.size();
    if (offset > from.content.size() || base + offset > from.content.size()) return -1;
    from.place = base + offset;
    return 0;
  };
  functions.zclose_file = [](void*, void*) { return 0; };
  functions.zerror_file = [](void*, void*) { return 0; };
  return functions;
}

/// Of the file that was found last. Debian's minizip gives the bytes of bzip2 as they are.
void refuse_other_packing(unzFile archive, const std::string& name, const std::string& file) {
  unz_file_info64 info{};
  if (unzGetCurrentFileInfo64(archive, &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK) return;
  if (info.compression_method == 0 || info.compression_method == Z_DEFLATED) return;
  const char* method = info.compression_method == 12 ? "bzip2" : info.compression_method == 14 ? "LZMA" : "a rare method";
  throw FileError(
      fmt::format("{}: '{}' in it is packed by {}, which is not read; unpack the archive and pack it again as zip does by default", file,
                  shown(name), method));
}

}  // namespace

ZipArchive::ZipArchive(std::string_view content, std::string file)
    : stream_(std::make_unique<Stream>(Stream{content})), file_(std::move(file)) {
  zlib_filefunc64_def functions = functions_of(*stream_);
  archive_ = unzOpen2_64("", &functions);
  if (!archive_) throw FileError(fmt::format("{}: its archive cannot be opened; the file is truncated or damaged", file_));
}

ZipArchive::~ZipArchive() { unzClose(archive_); }

std::optional<std::string> ZipArchive::read(const std::string& name, std::uint64_t most) const {
  if (unzLocateFile(archive_, name.c_str(), any_case) != UNZ_OK) return {};
  refuse_other_packing(archive_, name, file_);
  std::string bytes;
  int got = unzOpenCurrentFile(archive_) == UNZ_OK ? 1 : -1;
  while (got > 0 && bytes.size() <= most) {
    const std::size_t before = bytes.size();
    bytes.resize(before + piece);
    got = unzReadCurrentFile(archive_, bytes.data() + before, piece);
    bytes.resize(before + static_cast<std::size_t>(std::max(got, 0)));
  }
  if (bytes.size() > most) {
    throw FileError(fmt::format("{}: '{}' in it has more than the {} bytes that are read; make it smaller", file_, shown(name), most));
  }
  if (got < 0 || unzCloseCurrentFile(archive_) != UNZ_OK) {
    throw FileError(fmt::format("{}: '{}' in it cannot be unpacked; the file is truncated or damaged", file_, shown(name)));
  }
  return bytes;
}

}  // namespace homolog
