#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/base/os/file_content.h>

#include <chrono>
#include <filesystem>
#include <string>

#include "support/folder.h"

namespace tendon::os {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct FileContentTest : testing::Test {
  [[nodiscard]] FileWatch Watch() const { return FileWatch(*ReadContent(file)); }

  const test::Folder folder;
  const fs::path file = folder.path() / "file";
};

TEST_F(FileContentTest, ReadsInOrderAndHashesTheContent) {
  const std::string text(3'000'000, 'x');
  folder.Write("file", text + "end");
  std::string taken;

  const auto content = ReadContent(file, [&](std::span<const std::byte> bytes) -> Result<void> {
    taken.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return {};
  });

  ASSERT_TRUE(content) << content.error().message;
  EXPECT_EQ(taken, text + "end");
  EXPECT_EQ(content->stamp.size, taken.size());
  EXPECT_EQ(content->file, file);
  folder.Write("copy", taken);
  folder.Write("other", text + "End");
  EXPECT_EQ(ReadContent(folder.path() / "copy")->hash, content->hash);
  EXPECT_NE(ReadContent(folder.path() / "other")->hash, content->hash);
}

TEST_F(FileContentTest, ReadsAgainIfTheFileChangesMeanwhile) {
  folder.Write("file", "old");
  std::string taken;
  int attempts = 0;

  const auto content = ReadContent(
      file,
      [&](std::span<const std::byte> bytes) -> Result<void> {
        taken.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (attempts == 1) folder.Write("file", "newer");
        return {};
      },
      [&]() -> Result<void> {
        ++attempts;
        taken.clear();
        return {};
      });

  ASSERT_TRUE(content) << content.error().message;
  EXPECT_EQ(taken, "newer");
  EXPECT_EQ(attempts, 2);
}

TEST_F(FileContentTest, RefusesAFileThatKeepsChanging) {
  folder.Write("file", "old");
  int size = 0;

  const auto content = ReadContent(file, [&](std::span<const std::byte>) -> Result<void> {
    folder.Write("file", std::string(static_cast<std::size_t>(++size), 'x'));
    return {};
  });

  ASSERT_FALSE(content);
  EXPECT_THAT(content.error().message, HasSubstr("changes while it is read"));
}

TEST_F(FileContentTest, RefusesAMissingOrIrregularFile) {
  EXPECT_THAT(ReadContent(file).error().message, HasSubstr("cannot be read: No such file"));
  EXPECT_THAT(ReadContent(folder.path()).error().message, HasSubstr("is not a regular file"));
}

TEST_F(FileContentTest, DetectsChangedAndRestoredContent) {
  folder.Write("file", "code");
  FileWatch watch = Watch();
  EXPECT_EQ(watch.Check(), FileWatch::State::kSame);

  folder.Write("file", "Code");  // the same length as before
  EXPECT_EQ(watch.Check(), FileWatch::State::kOther);
  EXPECT_EQ(watch.Check(), FileWatch::State::kOther);
  EXPECT_GE(watch.written_now(), watch.content().stamp.written);

  folder.Write("file", "code");
  EXPECT_EQ(watch.Check(), FileWatch::State::kSame);
}

TEST_F(FileContentTest, DetectsAChangeDespiteAnEqualFileTime) {
  folder.Write("file", "code");
  const auto written = fs::last_write_time(file);
  FileWatch watch = Watch();

  folder.Write("file", "Code");
  fs::last_write_time(file, written);

  EXPECT_EQ(watch.Check(), FileWatch::State::kOther);
}

TEST_F(FileContentTest, IgnoresTouchingOrCopyingTheFile) {
  folder.Write("file", "code");
  FileWatch watch = Watch();

  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));
  EXPECT_EQ(watch.Check(), FileWatch::State::kSame);

  fs::copy_file(file, folder.path() / "copy");
  fs::rename(folder.path() / "copy", file);
  EXPECT_EQ(watch.Check(), FileWatch::State::kSame);
}

TEST_F(FileContentTest, DetectsARemovedAndRestoredFile) {
  folder.Write("file", "code");
  FileWatch watch = Watch();

  fs::remove(file);
  EXPECT_EQ(watch.Check(), FileWatch::State::kGone);
  EXPECT_EQ(watch.written_now(), 0);

  folder.Write("file", "code");
  EXPECT_EQ(watch.Check(), FileWatch::State::kSame);
}

}  // namespace
}  // namespace tendon::os
