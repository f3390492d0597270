#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/base/os/file.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace tendon {
namespace {

namespace fs = std::filesystem;

class FileTest : public testing::Test {
 protected:
  [[nodiscard]] std::string Content() const { return folder_.Read("file"); }
  static std::ptrdiff_t CountIn(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), {});
  }

  const test::Folder folder_;
  const fs::path file_ = folder_.path() / "file";
};

TEST_F(FileTest, AppendingCreatesTheFileAndExtendsIt) {
  ASSERT_TRUE(os::AppendDurably(file_, "one\n"));
  ASSERT_TRUE(os::AppendDurably(file_, "two\n"));

  EXPECT_EQ(Content(), "one\ntwo\n");
}

TEST_F(FileTest, ReplacingLeavesOnlyTheNewContent) {
  ASSERT_TRUE(os::ReplaceDurably(file_, "a long old text"));
  ASSERT_TRUE(os::ReplaceDurably(file_, "new"));

  EXPECT_EQ(Content(), "new");
  EXPECT_EQ(CountIn(folder_.path()), 1);
}

TEST_F(FileTest, AReplacementKeepsTheModeOfTheFile) {
  using enum fs::perms;
  for (const fs::perms mode : {owner_read | owner_write, owner_all | group_all | others_read}) {
    ASSERT_TRUE(os::ReplaceDurably(file_, "old"));
    fs::permissions(file_, mode);

    ASSERT_TRUE(os::ReplaceDurably(file_, "new"));

    EXPECT_EQ(fs::status(file_).permissions(), mode);
    EXPECT_EQ(Content(), "new");
  }
}

TEST_F(FileTest, AReplacementFollowsSymbolicLinks) {
  const fs::path inner = folder_.path() / "inner";
  fs::create_directory(inner);
  fs::create_symlink("inner/link", folder_.path() / "link");
  fs::create_symlink("../file", inner / "link");

  ASSERT_TRUE(os::ReplaceDurably(folder_.path() / "link", "made"));
  EXPECT_EQ(Content(), "made");
  ASSERT_TRUE(os::ReplaceDurably(folder_.path() / "link", "new"));

  EXPECT_EQ(Content(), "new");
  EXPECT_TRUE(fs::is_symlink(folder_.path() / "link"));
  EXPECT_TRUE(fs::is_symlink(inner / "link"));
  EXPECT_EQ(CountIn(inner), 1);
}

TEST_F(FileTest, ALoopOfSymbolicLinksIsAnError) {
  fs::create_symlink(file_, folder_.path() / "round");
  fs::create_symlink(folder_.path() / "round", file_);

  const auto replaced = os::ReplaceDurably(file_, "new");

  ASSERT_FALSE(replaced);
  EXPECT_EQ(replaced.error().message,
            "cannot write " + file_.string() + ": Too many levels of symbolic links");
}

TEST_F(FileTest, AReplacementLeavesOtherFilesAlone) {
  folder_.Write("file.new", "mine");
  folder_.Write(".saving-" + std::to_string(getpid()) + "-0", "of one that was killed");

  ASSERT_TRUE(os::ReplaceDurably(file_, "new"));

  EXPECT_EQ(Content(), "new");
  EXPECT_EQ(folder_.Read("file.new"), "mine");
  EXPECT_EQ(CountIn(folder_.path()), 3);
}

TEST_F(FileTest, RefusesToReplaceAnythingButAFile) {
  fs::create_directory(file_);
  folder_.Write("file/old", "old");

  EXPECT_FALSE(os::ReplaceDurably(file_, "new"));
  EXPECT_FALSE(os::ReplaceDurably("/dev/null", "new"));
  EXPECT_FALSE(os::ReplaceDurably(folder_.path() / "none" / "file", "new"));

  EXPECT_EQ(folder_.Read("file/old"), "old");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(CountIn(folder_.path()), 1);
}

TEST_F(FileTest, CheckingForWriteAccessLeavesNoTrace) {
  EXPECT_TRUE(os::CheckWritable(file_));
  EXPECT_EQ(CountIn(folder_.path()), 0);
  folder_.Write("file", "old");
  EXPECT_TRUE(os::CheckWritable(file_));
  EXPECT_EQ(Content(), "old");
  EXPECT_EQ(CountIn(folder_.path()), 1);

  const auto none = os::CheckWritable(folder_.path() / "none" / "file");
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "cannot write " + (folder_.path() / "none" / "file").string() +
                                      ": No such file or directory");
  EXPECT_FALSE(os::CheckWritable("/proc/file"));
}

TEST_F(FileTest, AFullDiskIsAnErrorThatNamesTheFile) {
  const auto written = os::AppendDurably("/dev/full", "text");

  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "cannot write /dev/full: No space left on device");
}

TEST_F(FileTest, ReadsAgainIfTheFileChangesMeanwhile) {
  folder_.Write("file", "old");
  int reads = 0;

  const auto read = os::ReadUnchanged(file_, [&]() -> Result<std::string> {
    const std::string half = Content();
    if (++reads == 1) folder_.Write("file", "the new");
    return half;
  });

  ASSERT_TRUE(read);
  EXPECT_EQ(*read, "the new");
  EXPECT_EQ(reads, 2);
}

TEST_F(FileTest, RefusesAFileThatKeepsChanging) {
  folder_.Write("file", "");

  const auto read = os::ReadUnchanged(file_, [&]() -> Result<std::string> {
    folder_.Write("file", Content() + "x");
    return Content();
  });

  ASSERT_FALSE(read);
  EXPECT_EQ(
      read.error().message,
      file_.string() +
          ": the file changes while it is read; try again when the file is completely written");
}

}  // namespace
}  // namespace tendon
