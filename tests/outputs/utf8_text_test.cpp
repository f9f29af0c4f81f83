// SPDX-License-Identifier: MIT
#include "homolog/outputs/utf8_text.h"

#include <gtest/gtest.h>

namespace homolog {
namespace {

TEST(Utf8Text, StaysWhatItIs) {
  for (const std::string text : {"", "a, \"b\"\n", "\xc3\xa9paule \xe2\x82\xac \xf0\x9f\xa6\xb4", "\xef\xbb\xbfx,y,z"})
    EXPECT_EQ(utf8_text(text), text);
}

TEST(Utf8Text, ElseIsWhatLatin1Says) {
  EXPECT_EQ(utf8_text("\xe9paule \xff\x80"), "\xc3\xa9paule \xc3\xbf\xc2\x80");
  EXPECT_EQ(utf8_text("\xc3"), "\xc3\x83");
}

}  // namespace
}  // namespace homolog
