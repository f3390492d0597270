#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/base/os/file.h>

#include <filesystem>
#include <string>

namespace tendon {
namespace {

class FileTest : public testing::Test {
 protected:
  [[nodiscard]] std::string Content() const { return folder_.Read("file"); }

  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "file";
};

TEST_F(FileTest, AppendingMakesTheFileAndAddsToIt) {
  ASSERT_TRUE(os::AppendDurably(file_, "one\n"));
  ASSERT_TRUE(os::AppendDurably(file_, "two\n"));

  EXPECT_EQ(Content(), "one\ntwo\n");
}

TEST_F(FileTest, ReplacingLeavesTheNewContentAlone) {
  ASSERT_TRUE(os::ReplaceDurably(file_, "a long old text"));
  ASSERT_TRUE(os::ReplaceDurably(file_, "new"));

  EXPECT_EQ(Content(), "new");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(FileTest, AReplacementThatFailsLeavesTheOldContent) {
  ASSERT_TRUE(os::ReplaceDurably(file_, "old"));
  std::filesystem::create_directory(folder_.path() / "file.new");

  EXPECT_FALSE(os::ReplaceDurably(file_, "new"));

  EXPECT_EQ(Content(), "old");
}

TEST_F(FileTest, ADiskThatIsFullIsAnErrorThatNamesTheFile) {
  const auto written = os::AppendDurably("/dev/full", "text");

  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().message, "cannot write /dev/full: No space left on device");
}

}  // namespace
}  // namespace tendon
