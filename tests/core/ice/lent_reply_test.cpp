#include <gtest/gtest.h>
#include <tendon/ice/ice_middleware.h>

#include <algorithm>
#include <future>
#include <memory>
#include <mutex>
#include <utility>

#include "conformance/recorder.h"

namespace tendon::ice {
namespace {

using conformance::FrameOf;
using conformance::kTestTimeout;

/// Answers a request with a body. The handle of the request is both the number of bytes and the
/// value of each byte.
class Filler final : public LinkHandler {
 public:
  explicit Filler(std::shared_ptr<Link> link) : link_(std::move(link)) { link_->Admit(); }

  void OnFrame(std::span<const std::byte> /*frame*/) override {}
  void OnDirectFrame(std::span<const std::byte> frame, ReplySlot& reply) override {
    FrameHeader header = *ReadWholeFrame(frame);
    header.size = header.handle;
    std::ranges::fill(*reply.Begin(header), static_cast<std::byte>(header.handle));
    if (header.handle != kBroken) reply.End();
  }
  void OnClosed(const Error& /*reason*/) override {}

  /// Replies of this size are begun and never ended.
  static constexpr std::uint32_t kBroken = 77'000;

 private:
  const std::shared_ptr<Link> link_;
};

/// Keeps borrowed answers, and copies all other answers.
class Borrower final : public LinkHandler {
 public:
  struct Heard {
    std::span<const std::byte> frame;
    std::shared_ptr<const void> owner;
    Bytes copy;
  };

  void OnFrame(std::span<const std::byte> frame) override {
    Put({.frame = {}, .owner = nullptr, .copy = Bytes(frame.begin(), frame.end())});
  }
  void OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner) override {
    Put({.frame = frame, .owner = std::move(owner), .copy = {}});
  }
  void OnClosed(const Error& /*reason*/) override {}

  std::future<Heard> Next() {
    const std::scoped_lock lock(mutex_);
    next_ = {};
    return next_.get_future();
  }

 private:
  void Put(Heard heard) {
    const std::scoped_lock lock(mutex_);
    next_.set_value(std::move(heard));
  }

  std::mutex mutex_;
  std::promise<Heard> next_;
};

class LentReply : public testing::Test {
 protected:
  LentReply() {
    auto listener = server_->Listen(
        "127.0.0.1:0", [](const auto& link) { return std::make_shared<Filler>(link); });
    EXPECT_TRUE(listener);
    listener_ = *std::move(listener);
    auto link = client_->Open(listener_->address(), borrower_, kTestTimeout);
    EXPECT_TRUE(link);
    link_ = *std::move(link);
    link_->Admit();
  }

  Borrower::Heard Ask(std::uint32_t size) {
    auto heard = borrower_->Next();
    EXPECT_EQ(link_->Send(FrameOf(size), Delivery::kDirect), Status(Status::kQueued));
    EXPECT_EQ(heard.wait_for(kTestTimeout), std::future_status::ready);
    return heard.get();
  }

  const std::shared_ptr<Middleware> server_ = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const std::shared_ptr<Middleware> client_ = MakeIceMiddleware(Exposure::kLoopbackOnly);
  const std::shared_ptr<Borrower> borrower_ = std::make_shared<Borrower>();
  std::unique_ptr<Listener> listener_;
  std::shared_ptr<Link> link_;
};

TEST_F(LentReply, ALargeReplyIsLentWithoutACopy) {
  constexpr std::uint32_t kFirst = 1'000'000;
  constexpr std::uint32_t kSecond = 900'001;

  const auto first = Ask(kFirst);
  const auto second = Ask(kSecond);
  link_->Close();

  ASSERT_NE(first.owner, nullptr);
  ASSERT_NE(second.owner, nullptr);
  EXPECT_TRUE(std::ranges::equal(first.frame, FrameOf(kFirst, kFirst)));
  EXPECT_TRUE(std::ranges::equal(second.frame, FrameOf(kSecond, kSecond)));
}

TEST_F(LentReply, ASmallReplyIsCopied) {
  const auto heard = Ask(100);

  EXPECT_EQ(heard.owner, nullptr);
  EXPECT_EQ(heard.copy, FrameOf(100, 100));
}

TEST_F(LentReply, AnUnfinishedReplyIsARefusal) {
  const auto heard = Ask(Filler::kBroken);

  const auto header = ReadWholeFrame(heard.copy);
  ASSERT_TRUE(header);
  EXPECT_EQ(header->type, MessageType::kRefusal);
  EXPECT_EQ(Ask(100).copy, FrameOf(100, 100)) << "the link lives";
}

}  // namespace
}  // namespace tendon::ice
