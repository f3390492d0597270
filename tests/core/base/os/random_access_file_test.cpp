#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/base/os/random_access_file.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace tendon {
namespace {

std::span<const std::byte> BytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

class RandomAccessFileTest : public testing::Test {
 protected:
  const test::Folder folder_;
  const std::filesystem::path file_ = folder_.path() / "file";
};

TEST_F(RandomAccessFileTest, PartsAreWrittenOneAfterTheOther) {
  auto file = os::CreateWritableFile(file_);
  ASSERT_TRUE(file) << file.error().message;
  const std::vector<std::span<const std::byte>> many(20, BytesOf("ab"));

  ASSERT_TRUE((*file)->WriteAt(0, std::array{BytesOf("one "), BytesOf(""), BytesOf("two")}));
  ASSERT_TRUE((*file)->WriteAt(4, many));

  std::string expected = "one ";
  for (int i = 0; i < 20; ++i) expected += "ab";
  EXPECT_EQ(folder_.Read("file"), expected);
}

TEST_F(RandomAccessFileTest, ReservedSpaceIsNotPartOfTheFile) {
  auto file = os::CreateWritableFile(file_);
  ASSERT_TRUE(file);
  ASSERT_TRUE((*file)->WriteAt(0, std::array{BytesOf("content")}));

  ASSERT_TRUE((*file)->Reserve(7, 100'000));
  ASSERT_TRUE((*file)->Sync());
  EXPECT_EQ(folder_.Read("file"), "content");
  ASSERT_TRUE((*file)->Truncate(4));
  EXPECT_EQ(folder_.Read("file"), "cont");
}

TEST_F(RandomAccessFileTest, ReadsAnyPlaceOfTheFile) {
  folder_.Write("file", "0123456789");
  const auto file = os::OpenRandomAccessFile(file_);
  ASSERT_TRUE(file);
  std::array<std::byte, 3> bytes{};

  EXPECT_EQ((*file)->size(), 10U);
  ASSERT_TRUE((*file)->ReadAt(7, bytes));
  EXPECT_EQ(bytes[0], std::byte{'7'});
  const auto beyond = (*file)->ReadAt(8, bytes);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().message,
            "cannot read 3 bytes at 8 of " + file_.string() + ": the file has become shorter");
}

TEST_F(RandomAccessFileTest, AFileIsCreatedOnlyOnce) {
  const auto first = os::CreateWritableFile(file_);
  ASSERT_TRUE(first);

  const auto second = os::CreateWritableFile(file_);

  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().code, ErrorCode::kExists);
}

TEST_F(RandomAccessFileTest, ShowsWhetherTheFileIsBeingWritten) {
  auto writer = os::CreateWritableFile(file_);
  ASSERT_TRUE(writer);
  const auto reader = os::OpenRandomAccessFile(file_);
  ASSERT_TRUE(reader);

  EXPECT_TRUE((*reader)->is_being_written());
  writer->reset();
  EXPECT_FALSE((*reader)->is_being_written());
}

TEST_F(RandomAccessFileTest, AFileIsOpenedAgainForWriting) {
  auto created = *os::CreateWritableFile(file_);
  const auto identity = created->identity();
  ASSERT_TRUE(created->WriteAt(0, std::array{BytesOf("one ")}));
  created.reset();

  const auto file = os::ReopenWritableFile(file_, identity, 4);

  ASSERT_TRUE(file) << file.error().message;
  ASSERT_TRUE((*file)->WriteAt(4, std::array{BytesOf("two")}));
  EXPECT_EQ(folder_.Read("file"), "one two");
  EXPECT_TRUE((*os::OpenRandomAccessFile(file_))->is_being_written());
}

TEST_F(RandomAccessFileTest, AFileOfAnotherProgramIsNotOpenedAgain) {
  auto created = *os::CreateWritableFile(file_);
  const auto identity = created->identity();
  const auto refusal = [&](const std::filesystem::path& file, std::uint64_t size) {
    const auto opened = os::ReopenWritableFile(file, identity, size);
    return opened ? "" : opened.error().message;
  };
  const std::string begin = "cannot open " + file_.string() + " again: ";
  const std::string end = ": repeat this in a folder that no other program uses";

  EXPECT_EQ(refusal(file_, 0), begin + "another program is writing it" + end);
  created.reset();
  folder_.Write("file", "other");
  EXPECT_EQ(refusal(file_, 4),
            begin + "another program has changed it, so it has 5 bytes instead of 4" + end);
  std::filesystem::rename(file_, folder_.path() / "former");
  folder_.Write("file", "other");
  EXPECT_EQ(refusal(file_, 5), begin + "another program has replaced it" + end);
  std::filesystem::create_symlink(folder_.path() / "former", folder_.path() / "link");
  EXPECT_NE(refusal(folder_.path() / "link", 5), "");
  EXPECT_EQ(
      refusal(folder_.path() / "none", 4),
      "cannot open " + (folder_.path() / "none").string() + " again: No such file or directory");
}

TEST_F(RandomAccessFileTest, AFolderIsNoFile) {
  const auto folder = os::OpenRandomAccessFile(folder_.path());
  const auto none = os::OpenRandomAccessFile(folder_.path() / "none");

  EXPECT_FALSE(folder);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace tendon
