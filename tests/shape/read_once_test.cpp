// SPDX-License-Identifier: MIT
#include "homolog/shape/read_once.h"

#include <gtest/gtest.h>

#include <assimp/IOStream.hpp>
#include <memory>

namespace homolog {
namespace {

TEST(ReadOnce, IsTheOnlyFile) {
  ReadOnce files("AC3Db", "scene.ac");
  EXPECT_TRUE(files.Exists("scene.ac"));
  for (const char* name : {"fur.png", "/etc/passwd", ""}) {
    EXPECT_FALSE(files.Exists(name));
    EXPECT_EQ(files.Open(name, "rb"), nullptr);
  }
}

TEST(ReadOnce, ForgetsWhatWasReadWhole) {
  const std::string letters(1 << 20, 'x');
  std::string content = letters + "y";
  ReadOnce files(content, "scene.ac");
  const std::unique_ptr<Assimp::IOStream> stream(files.Open("scene.ac", "rb"));
  std::string copy(content.size(), '\0');
  EXPECT_EQ(stream->Read(copy.data(), 1, 1 << 20), 1u << 20);
  EXPECT_EQ(content, letters + "y") << "there is more to be read";
  stream->Seek(0, aiOrigin_SET);
  EXPECT_EQ(stream->Read(copy.data(), 1, copy.size()), copy.size());
  EXPECT_EQ(copy, letters + "y");
#ifdef __linux__
  EXPECT_NE(content, copy);
#endif
}

}  // namespace
}  // namespace homolog
