// SPDX-License-Identifier: MIT
#include "homolog/outputs/write_file.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "homolog/base/errors.h"
#include "homolog/base/parallel.h"

namespace homolog {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

struct WriteFile : testing::Test {
  fs::path folder =
      fs::path(testing::TempDir()) / ("write_file_test_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));

  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  std::string read(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder / name, std::ios::binary).rdbuf();
    return text.str();
  }
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path().filename().string());
    return found;
  }
};

TEST_F(WriteFile, WritesBytesAsTheyAreAndReplacesWhatWasThere) {
  write_file(folder / "a.txt", "a much longer old text");
  const std::string bytes("one\r\n\0two", 9);
  write_file(folder / "a.txt", bytes);
  EXPECT_EQ(read("a.txt"), bytes);
  EXPECT_THAT(names(), UnorderedElementsAre("a.txt"));
}

TEST_F(WriteFile, FollowsALinkWhichStaysOne) {
  write_file(folder / "file", "before");
  fs::create_symlink("file", folder / "link");
  write_file(folder / "link", "after");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(read("file"), "after");
  fs::create_symlink("nowhere", folder / "loose");
  write_file(folder / "loose", "here");
  EXPECT_EQ(read("loose"), "here");
}

TEST_F(WriteFile, WritesStraightIntoADeviceOrAPipe) {
  const fs::path pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int end = open(pipe.c_str(), O_RDWR | O_NONBLOCK);
  write_file(pipe, "bytes");
  char bytes[8] = {};
  EXPECT_EQ(::read(end, bytes, sizeof bytes), 5);
  EXPECT_STREQ(bytes, "bytes");
  close(end);
  EXPECT_TRUE(fs::is_fifo(pipe));
  fs::create_symlink("/dev/full", folder / "full");
  EXPECT_THROW(write_file(folder / "full", "bytes"), OutputError);
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(WriteFile, WritesSeveral) {
  write_files({{folder / "a", "1"}, {folder / "b", ""}});
  EXPECT_EQ(read("a"), "1");
  EXPECT_THAT(names(), UnorderedElementsAre("a", "b"));
}

TEST_F(WriteFile, ChangesNothingWhenOneOfThemCannotBeWritten) {
  write_file(folder / "a", "old");
  fs::create_directory(folder / "b");
  EXPECT_THROW(write_files({{folder / "a", "new"}, {folder / "b", "new"}}), OutputError);
  EXPECT_EQ(read("a"), "old");
  EXPECT_THAT(names(), UnorderedElementsAre("a", "b"));
}

TEST_F(WriteFile, ChangesNothingWhenMakingOneOfThemFailsHalfWay) {
  write_file(folder / "a", "old");
  const auto fail = [](const Sink& sink) {
    sink("half");
    throw ShapeError("no more");
  };
  EXPECT_THROW(write_files(std::vector<StreamedFile>{{folder / "a", whole("new")}, {folder / "b", fail}}), ShapeError);
  EXPECT_EQ(read("a"), "old");
  EXPECT_THAT(names(), UnorderedElementsAre("a"));
}

TEST_F(WriteFile, KeepsWhatTheResultsWereMadeFrom) {
  write_file(folder / "a", "old");
  EXPECT_THROW(write_files({{folder / "b", "new"}, {folder / "." / "a", "new"}}, {folder / "not there", folder / "a"}), OutputError);
  EXPECT_EQ(read("a"), "old");
  EXPECT_THAT(names(), UnorderedElementsAre("a"));
}

TEST_F(WriteFile, NamesTheFileTheReasonAndWhatToDo) {
  write_file(folder / "file", "");
  const auto message = [&](const fs::path& path) -> std::string {
    try {
      write_file(path, "text");
    } catch (const OutputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message(folder / "file" / "below.txt"), AllOf(HasSubstr("below.txt"), HasSubstr("a file is where its folder should be")));
  EXPECT_THAT(message(folder / "nowhere" / "a.txt"), HasSubstr("its folder is not there; make it first"));
  EXPECT_THAT(message(folder / std::string(300, 'a')), HasSubstr("choose a shorter one"));
}

TEST_F(WriteFile, RemovesWhatTheDeadHaveLeftAndNothingOfTheLiving) {
  for (const char* name : {".homolog.1.a.partial", ".homolog.2.b.partial", ".other.partial", ".homolog.txt"}) {
    std::ofstream(folder / name) << "half";
  }
  const int living = open((folder / ".homolog.2.b.partial").c_str(), O_RDONLY);
  ASSERT_EQ(flock(living, LOCK_EX), 0);
  write_file(folder / "a", "1");
  EXPECT_THAT(names(), UnorderedElementsAre("a", ".homolog.2.b.partial", ".other.partial", ".homolog.txt"));
  close(living);  // as its death would
  write_files({{folder / "b", "2"}});
  EXPECT_THAT(names(), UnorderedElementsAre("a", "b", ".other.partial", ".homolog.txt"));
}

TEST_F(WriteFile, ManyWriteIntoOneFolderAtOnce) {
  parallel_for(64, [&](std::size_t i) {
    const std::string name = std::to_string(i % 8);
    write_files({{folder / name, std::string(10000, name[0])}, {folder / ("other" + name), name}});
  });
  EXPECT_EQ(names().size(), 16u);
  for (char name = '0'; name < '8'; ++name) EXPECT_EQ(read({name}), std::string(10000, name));
}

}  // namespace
}  // namespace homolog
