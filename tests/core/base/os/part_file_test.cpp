#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/base/os/part_file.h>

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace tendon::os {
namespace {

using testing::HasSubstr;

class PartFileTest : public testing::Test {
 protected:
  [[nodiscard]] bool HasPart() const {
    return std::filesystem::exists(folder.path() / "run.h5.part");
  }

  const test::Folder folder;
  const std::filesystem::path file = folder.path() / "run.h5";
};

TEST_F(PartFileTest, APartThatIsGoneGetsNoName) {
  auto part = PartFile::Create(file);
  ASSERT_TRUE(part) << part.error().message;
  part->TakeFile().reset();
  std::filesystem::remove(part->part());

  const auto completed = part->Complete();

  ASSERT_FALSE(completed);
  EXPECT_THAT(completed.error().message, HasSubstr("run.h5.part to the disk: No such file"));
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(PartFileTest, GetsItsNameWhenItIsComplete) {
  {
    auto part = PartFile::Create(file);
    ASSERT_TRUE(part) << part.error().message;
    const std::array content{std::as_bytes(std::span("good", 4))};
    ASSERT_TRUE(part->TakeFile()->WriteAt(0, content));
    EXPECT_FALSE(std::filesystem::exists(file));

    ASSERT_TRUE(part->Complete());
  }

  EXPECT_EQ(folder.Read("run.h5"), "good");
  EXPECT_FALSE(HasPart());
}

TEST_F(PartFileTest, LeavesNothingIfItIsNotCompleted) {
  {
    const auto part = PartFile::Create(file);
    ASSERT_TRUE(part);
    EXPECT_TRUE(HasPart());
  }

  EXPECT_FALSE(HasPart());
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST_F(PartFileTest, ReplacesNoFileAlsoIfItComesLater) {
  folder.Write("run.h5", "of somebody else");
  const auto early = PartFile::Create(file);
  std::filesystem::remove(file);
  auto part = PartFile::Create(file);
  ASSERT_TRUE(part);
  folder.Write("run.h5", "of somebody else");

  const auto late = part->Complete();

  ASSERT_FALSE(early);
  EXPECT_EQ(early.error().code, ErrorCode::kExists);
  EXPECT_THAT(early.error().message, HasSubstr("choose another name"));
  ASSERT_FALSE(late);
  EXPECT_EQ(folder.Read("run.h5"), "of somebody else");
}

TEST_F(PartFileTest, ReplacesWhatAKilledProgramHasLeft) {
  folder.Write("run.h5.part", "half");

  auto part = PartFile::Create(file);

  ASSERT_TRUE(part) << part.error().message;
  ASSERT_TRUE(part->Complete());
  EXPECT_EQ(folder.Read("run.h5"), "");
}

TEST_F(PartFileTest, LeavesThePartOfAProgramThatIsStillWriting) {
  auto part = PartFile::Create(file);
  ASSERT_TRUE(part);
  const auto open = part->TakeFile();

  const auto other = PartFile::Create(file);

  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::kExists);
  EXPECT_THAT(other.error().message, HasSubstr("another program is writing"));
  EXPECT_TRUE(HasPart());
}

TEST_F(PartFileTest, AFolderIsLockedOnce) {
  auto first = LockFolder(folder.path());
  ASSERT_TRUE(first);
  EXPECT_FALSE(LockFolder(folder.path()));

  first.reset();

  EXPECT_TRUE(LockFolder(folder.path()));
}

TEST_F(PartFileTest, NamesTheReasonIfItCannotBeCreated) {
  const auto part = PartFile::Create(folder.path() / "none" / "run.h5");

  ASSERT_FALSE(part);
  EXPECT_THAT(part.error().message, HasSubstr("No such file or directory"));
}

}  // namespace
}  // namespace tendon::os
