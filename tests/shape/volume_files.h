// SPDX-License-Identifier: MIT
// Volume files for the tests and fuzz targets, made in code: a box of ones (and of twos beside it) in 8 x 6 x 5 voxels of one byte.
#pragma once

#include <zlib.h>

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace homolog::volumes {

inline constexpr std::array<int, 3> size{8, 6, 5};

/// Ones where 1 <= x < 4, 1 <= y < 5, 1 <= z < 4; twos where 5 <= x < 7 likewise.
inline std::string voxels(bool with_twos = false) {
  std::string bytes;
  for (int z = 0; z < size[2]; ++z) {
    for (int y = 0; y < size[1]; ++y) {
      for (int x = 0; x < size[0]; ++x) {
        const bool within = y >= 1 && y < 5 && z >= 1 && z < 4;
        bytes += within && x >= 1 && x < 4 ? '\1' : within && with_twos && x >= 5 && x < 7 ? '\2' : '\0';
      }
    }
  }
  return bytes;
}

inline std::string compressed(const std::string& bytes, bool gzip) {
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, gzip ? 15 + 16 : 15, 9, Z_DEFAULT_STRATEGY);
  std::string packed(bytes.size() + 1000, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(packed.data());
  z.avail_out = static_cast<uInt>(packed.size());
  deflate(&z, Z_FINISH);
  packed.resize(z.total_out);
  deflateEnd(&z);
  return packed;
}

template <class T>
void put(std::string& bytes, std::size_t at, T value, std::endian order) {
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[at + i] = raw[order == std::endian::native ? i : sizeof(T) - 1 - i];
}

/// NIfTI-1 with an sform of spacings 2, 3, 4 and origin 10, 20, 30 (RAS), and a qform that says the same when `sform` is false.
inline std::string nifti(bool sform = true, std::endian order = std::endian::little, const std::string& content = voxels()) {
  std::string bytes(352, '\0');
  put<std::int32_t>(bytes, 0, 348, order);
  const std::int16_t dim[4] = {3, size[0], size[1], size[2]};
  for (std::size_t i = 0; i < 4; ++i) put(bytes, 40 + 2 * i, dim[i], order);
  put<std::int16_t>(bytes, 70, 2, order);
  const float pixdim[4] = {1, 2, 3, 4}, origin[3] = {10, 20, 30};
  for (std::size_t i = 0; i < 4; ++i) put(bytes, 76 + 4 * i, pixdim[i], order);
  put<float>(bytes, 108, 352, order);
  put<std::int16_t>(bytes, sform ? 254 : 252, 1, order);
  for (std::size_t i = 0; i < 3; ++i) {
    put(bytes, 268 + 4 * i, origin[i], order);
    put(bytes, 280 + 20 * i, pixdim[i + 1], order);
    put(bytes, 292 + 16 * i, origin[i], order);
  }
  bytes.replace(344, 3, "n+1");
  return bytes + content;
}

/// NIfTI-2 with the same sform.
inline std::string nifti2(std::endian order = std::endian::big) {
  std::string bytes(544, '\0');
  put<std::int32_t>(bytes, 0, 540, order);
  bytes.replace(4, 8, std::string("n+2\0\r\n\032\n", 8));
  put<std::int16_t>(bytes, 12, 2, order);
  const std::int64_t dim[4] = {3, size[0], size[1], size[2]};
  for (std::size_t i = 0; i < 4; ++i) put(bytes, 16 + 8 * i, dim[i], order);
  put<std::int64_t>(bytes, 168, 544, order);
  put<std::int32_t>(bytes, 348, 1, order);
  for (std::size_t i = 0; i < 3; ++i) {
    put(bytes, 400 + 40 * i, 2.0 + static_cast<double>(i), order);
    put(bytes, 424 + 32 * i, 10.0 + 10 * static_cast<double>(i), order);
  }
  return bytes + voxels();
}

/// The same place as nifti(), as RAS or as LPS.
inline std::string nrrd(bool gzip = false, bool ras = true, const std::string& extra = "", const std::string& content = voxels(),
                        const std::string& type = "uchar") {
  const std::string sign = ras ? "" : "-";
  const std::string header = "NRRD0004\n# made in code\ntype: " + type +
                             "\ndimension: 3\nspace: " + std::string(ras ? "right-anterior-superior" : "left-posterior-superior") +
                             "\nsizes: 8 6 5\nspace directions: (" + sign + "2,0,0) (0," + sign +
                             "3,0) (0,0,4)\nkinds: domain domain domain\nencoding: " + (gzip ? "gzip" : "raw") + "\nspace origin: (" +
                             sign + "10," + sign + "20,30)\nowner:=nobody\n" + extra + "\n";
  return header + (gzip ? compressed(content, true) : content);
}

/// The same place again; `file` is LOCAL or the name of the file of voxels.
inline std::string metaimage(bool zlib = false, const std::string& file = "LOCAL") {
  const std::string header =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" +
      std::string(zlib ? "CompressedData = True\n" : "") +
      "TransformMatrix = -1 0 0 0 -1 0 0 0 1\nOffset = -10 -20 30\nCenterOfRotation = 0 0 0\nElementSpacing = 2 3 4\nDimSize = 8 6 5\n"
      "ElementType = MET_UCHAR\nElementDataFile = " +
      file + "\n";
  return header + (file != "LOCAL" ? "" : zlib ? compressed(voxels(), false) : voxels());
}

}  // namespace homolog::volumes
