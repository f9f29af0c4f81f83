// SPDX-License-Identifier: MIT
#include "homolog/shape/foreign_file.h"

#include <gmock/gmock.h>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

std::string refusal(const std::string& content, const std::string& extension) {
  try {
    refuse_foreign(content, extension, "it");
  } catch (const FileError& error) {
    return error.what();
  }
  return "";
}

/// Without a mark, the larger byte first or second.
std::string utf16(const std::string& text, std::size_t large) {
  std::string bytes;
  for (const char letter : text) (bytes += letter).insert(bytes.size() - 1 + large, 1, '\0');
  return bytes;
}

TEST(ForeignFile, IsToldByHowItBegins) {
  EXPECT_EQ(refusal("ISO-10303-21;\n", ".stl"), "it: this is a STEP file of a CAD program; export its surface from there as STL or 3MF");
  EXPECT_THAT(refusal("\n <!DOCTYPE HTML><title>404</title>", ".obj"), testing::HasSubstr("a web page"));
  EXPECT_THAT(refusal(std::string("\xff\xfev\0", 4), ".obj"), testing::HasSubstr("UTF-16"));
  EXPECT_THAT(refusal(utf16("v 0 0 0\nv 1 0 0\n", 0), ".obj"), testing::HasSubstr("UTF-16"));
  EXPECT_THAT(refusal(utf16("OFF\n3 1", 1), ".off"), testing::HasSubstr("UTF-16"));
  EXPECT_THAT(refusal(std::string("\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0U\0p\0", 20), ".skp"), testing::HasSubstr("SketchUp"));
  EXPECT_THAT(refusal("\x28\xb5\x2f\xfd", ".blend"), testing::HasSubstr("zstd"));
  EXPECT_THAT(refusal(R"({"error":"404 Not Found"})", ".stl"), testing::HasSubstr("download the file again"));
  EXPECT_THAT(refusal("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", ".obj"), testing::HasSubstr("old Macs"));
  EXPECT_THAT(refusal(std::string(128, '\0') + "DICM and more", ".dcm"), testing::HasSubstr("DICOM"));
  EXPECT_THAT(refusal("\x1f\x8b", ".mgz"), testing::HasSubstr("FreeSurfer"));
  EXPECT_THAT(refusal("\x1f\x8b", ".gz"), testing::HasSubstr("gzip"));
}

TEST(ForeignFile, IsNoneWhereItIsReadOrNotKnown) {
  for (const char* content : {"", "\n", "OFF\n0 0 0\n", "solid <html>\n", "v 0 0 0\r\nv 1 0 0\r\n"})
    EXPECT_EQ(refusal(content, ".off"), "");
  EXPECT_EQ(refusal(utf16("a header of a binary STL, written as wide", 0) + std::string(4, '\1'), ".stl"), "");
}

TEST(ForeignFile, MarksBeforeTextAreLeftOut) {
  EXPECT_EQ(without_byte_order_mark("\xef\xbb\xbfOFF"), "OFF");
  EXPECT_EQ(without_byte_order_mark("OFF"), "OFF");
}

}  // namespace
}  // namespace homolog
