// SPDX-License-Identifier: MIT
#include "homolog/shape/read_in_child.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <csignal>

#include "homolog/base/errors.h"

namespace homolog {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

std::string message(const std::function<Mesh()>& read, const ChildLimits& limits = {}) {
  try {
    read_in_child(read, "a.glb", limits);
  } catch (const FileError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(ReadInChild, BringsTheMesh) {
  Mesh mesh;
  for (int i = 0; i < 100000; ++i) {  // more than a pipe holds
    mesh.vertices.emplace_back(i, 0.1, -1e300);
    mesh.triangles.push_back({0u, 1u, static_cast<std::uint32_t>(i)});
  }
  const Mesh brought = read_in_child([&] { return mesh; }, "a.glb", {});
  EXPECT_EQ(brought.vertices, mesh.vertices);
  EXPECT_EQ(brought.triangles, mesh.triangles);
  EXPECT_TRUE(read_in_child([] { return Mesh{}; }, "a.glb", {}).vertices.empty());
}

TEST(ReadInChild, BringsTheErrorOfTheReader) {
  EXPECT_EQ(message([]() -> Mesh { throw FileError("a.glb, line 7: so it is"); }), "a.glb, line 7: so it is");
}

TEST(ReadInChild, ACrashIsOneSentence) {
  const int parent = getpid();
  for (const int how : {SIGSEGV, SIGABRT, SIGKILL}) {
    EXPECT_THAT(message([&] { return raise(how), Mesh{}; }), HasSubstr("a.glb: the library that reads this format crashed on it"));
  }
  EXPECT_THAT(message([]() -> Mesh { throw std::out_of_range("of its own"); }), HasSubstr("crashed"));
  EXPECT_THAT(message([]() -> Mesh { _exit(0); }), HasSubstr("crashed"));
  EXPECT_EQ(getpid(), parent);
}

TEST(ReadInChild, TimeAndMemoryAreLimited) {
  ChildLimits limits{std::uint64_t{64} << 20, 1};
  EXPECT_THAT(message(
                  [] {
                    for (volatile bool forever = true; forever;) {
                    }
                    return Mesh{};
                  },
                  limits),
              HasSubstr("a.glb: reading it takes more than 1 s"));
  const auto eat = [] {
    Mesh mesh;
    mesh.vertices.resize(10000000);  // 240 MB
    return mesh;
  };
  EXPECT_THAT(message(eat, limits),
              AnyOf(HasSubstr("takes more than 64 MiB of memory"), HasSubstr("crashed")));  // the latter under sanitizers
}

}  // namespace
}  // namespace homolog
