#include <gtest/gtest.h>
#include <support/folder.h>
#include <tendon/middleware/body.h>
#include <tendon/middleware/hello.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

namespace tendon {
namespace {

namespace fs = std::filesystem;

TEST(ReadRefusal, AnUnreadableReasonIsStillARefusal) {
  EXPECT_EQ(ReadRefusal(Bytes(3), "robot"),
            (Error{ErrorCode::kFailed,
                   "robot refused the request, but the reason that it sent cannot be read"}));
}

/// A test with its own run-time folder.
class LoopbackCookieTest : public testing::Test {
 protected:
  void SetUp() override { setenv("XDG_RUNTIME_DIR", base_.c_str(), 1); }
  void TearDown() override { unsetenv("XDG_RUNTIME_DIR"); }
  [[nodiscard]] fs::path file() const { return base_ / "tendon" / "cookie"; }

  const test::Folder folder_;
  const fs::path base_ = folder_.path();
};

TEST_F(LoopbackCookieTest, IsCreatedOnceAndShared) {
  const auto first = LoopbackCookie();
  const auto second = LoopbackCookie();

  ASSERT_TRUE(first) << first.error().message;
  ASSERT_TRUE(second);
  EXPECT_NE(*first, 0U);
  EXPECT_EQ(*first, *second);
}

TEST_F(LoopbackCookieTest, CanBeReadByItsUserOnly) {
  ASSERT_TRUE(LoopbackCookie());

  EXPECT_EQ(fs::status(file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(std::distance(fs::directory_iterator(file().parent_path()), {}), 1) << "drafts remain";
}

TEST_F(LoopbackCookieTest, ConcurrentCreatorsAgree) {
  std::vector<std::uint64_t> cookies(16);
  std::vector<std::thread> makers;
  for (auto& cookie : cookies) {
    makers.emplace_back([&cookie] { cookie = *LoopbackCookie(); });
  }
  for (auto& maker : makers) maker.join();

  EXPECT_EQ(cookies, std::vector<std::uint64_t>(16, cookies.front()));
}

TEST_F(LoopbackCookieTest, RefusesAFileReadableByOthers) {
  ASSERT_TRUE(LoopbackCookie());
  fs::permissions(file(), fs::perms::others_read, fs::perm_options::add);

  const auto cookie = LoopbackCookie();

  ASSERT_FALSE(cookie);
  EXPECT_EQ(cookie.error().code, ErrorCode::kDenied);
}

TEST_F(LoopbackCookieTest, RefusesASymbolicLink) {
  ASSERT_TRUE(LoopbackCookie());
  fs::rename(file(), base_ / "elsewhere");
  fs::create_symlink(base_ / "elsewhere", file());

  EXPECT_FALSE(LoopbackCookie());
}

TEST_F(LoopbackCookieTest, NamesADamagedFile) {
  ASSERT_TRUE(LoopbackCookie());
  std::ofstream(file(), std::ios::trunc) << "no number";

  const auto cookie = LoopbackCookie();

  ASSERT_FALSE(cookie);
  EXPECT_EQ(
      cookie.error(),
      (Error{ErrorCode::kInvalid,
             file().string() + " is damaged: remove this file, then start the program again"}));
}

}  // namespace
}  // namespace tendon
