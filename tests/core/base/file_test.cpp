#include <gtest/gtest.h>
#include <tendon/base/os/file.h>
#include <tendon/base/os/process.h>

#include <fstream>
#include <sstream>
#include <string>

namespace tendon {
namespace {

class FileTest : public testing::Test {
 protected:
  FileTest() { std::filesystem::create_directories(folder_); }
  ~FileTest() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string Content() const {
    std::stringstream text;
    text << std::ifstream(file_, std::ios::binary).rdbuf();
    return text.str();
  }

  const std::filesystem::path folder_ = std::filesystem::temp_directory_path() /
                                        ("tendon-file-" + std::to_string(os::RandomNumber()));
  const std::filesystem::path file_ = folder_ / "file";
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
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(FileTest, AReplacementThatFailsLeavesTheOldContent) {
  ASSERT_TRUE(os::ReplaceDurably(file_, "old"));
  std::filesystem::create_directory(folder_ / "file.new");

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
