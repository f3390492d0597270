#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <span>
#include <utility>

#include "core/process/connections/remote_connection.h"

namespace {

using tendon::Bytes;
using tendon::Status;

/// How what came to a process was asked, and how it was answered.
struct Ways {
  std::atomic<int> sent{0};
  std::atomic<int> asked{0};     // by a way that has a shorter one back
  std::atomic<int> answered{0};  // by that
};

/// An answer that is counted when it is left, now or later.
class CountedAnswer final : public tendon::ReplySlot {
 public:
  CountedAnswer(tendon::ReplySlot& answer, std::shared_ptr<Ways> ways)
      : answer_(answer), ways_(std::move(ways)) {}
  CountedAnswer(std::unique_ptr<tendon::ReplySlot> later, std::shared_ptr<Ways> ways)
      : later_(std::move(later)), answer_(*later_), ways_(std::move(ways)) {}

 private:
  std::optional<std::span<std::byte>> MakeRoom(const tendon::FrameHeader& header) override {
    return answer_.Begin(header);
  }
  void OnEnd() override {
    ++ways_->answered;  // before whoever asked goes on
    answer_.End();
  }
  std::unique_ptr<tendon::ReplySlot> MakeDeferred() override {
    auto later = answer_.Defer();
    return later ? std::make_unique<CountedAnswer>(std::move(later), ways_) : nullptr;
  }

  const std::unique_ptr<tendon::ReplySlot> later_;
  tendon::ReplySlot& answer_;
  const std::shared_ptr<Ways> ways_;
};

/// A middleware that counts, on the links that it accepts.
class WayCounter final : public tendon::Middleware {
 public:
  WayCounter(std::shared_ptr<tendon::Middleware> below, std::shared_ptr<Ways> ways)
      : below_(std::move(below)), ways_(std::move(ways)) {}

  [[nodiscard]] std::string_view name() const override { return below_->name(); }
  tendon::Result<std::unique_ptr<tendon::Listener>> Listen(const std::string& address,
                                                           tendon::AcceptLink accept) override {
    return below_->Listen(
        address,
        [accept = std::move(accept), ways = ways_](
            const std::shared_ptr<tendon::Link>& link) -> std::shared_ptr<tendon::LinkHandler> {
          auto handler = accept(link);
          if (!handler) return nullptr;
          return std::make_shared<Ear>(std::move(handler), ways);
        });
  }
  tendon::Result<std::shared_ptr<tendon::Link>> Open(const std::string& address,
                                                     std::shared_ptr<tendon::LinkHandler> handler,
                                                     std::chrono::milliseconds timeout) override {
    return below_->Open(address, std::move(handler), timeout);
  }

 private:
  class Ear final : public tendon::LinkHandler {
   public:
    Ear(std::shared_ptr<tendon::LinkHandler> handler, std::shared_ptr<Ways> ways)
        : handler_(std::move(handler)), ways_(std::move(ways)) {}
    void OnFrame(std::span<const std::byte> frame) override {
      ++ways_->sent;
      handler_->OnFrame(frame);
    }
    void OnDirectFrame(std::span<const std::byte> frame, tendon::ReplySlot& answer) override {
      ++ways_->asked;
      CountedAnswer counted(answer, ways_);
      handler_->OnDirectFrame(frame, counted);
    }
    void OnClosed(const tendon::Error& reason) override { handler_->OnClosed(reason); }

   private:
    const std::shared_ptr<tendon::LinkHandler> handler_;
    const std::shared_ptr<Ways> ways_;
  };

  const std::shared_ptr<tendon::Middleware> below_;
  const std::shared_ptr<Ways> ways_;
};

/// What the desk calls of the robot's plant.
class WayOfAnswers : public RemoteConnection {
 protected:
  WayOfAnswers() {
    auto options = Options();
    options.middleware = std::make_shared<WayCounter>(options.middleware, ways_);
    robot = std::make_unique<tendon::Process>("robot", options);
    plant = &robot->Add<plant::Plant>("plant");
    EXPECT_TRUE(robot->WaitUntilJoined(std::chrono::seconds(20)).ok());
    EXPECT_TRUE(robot->StartAll().ok());
    StartDesk();
    Connect();
  }
  [[nodiscard]] static bool HasAShorterWay() { return GetParam().name != "tcp"; }

  const std::shared_ptr<Ways> ways_ = std::make_shared<Ways>();
};

INSTANTIATE_TEST_SUITE_P(Over, WayOfAnswers, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

constexpr int kCalls = 20;

TEST_P(WayOfAnswers, AReadIsAnsweredByTheShorterWayWhereThereIsOne) {
  plant::Move move;
  ASSERT_TRUE(EventuallyTrue([&] { return user->get_move(move) == Status(Status::kDone); }));
  const int asked = ways_->asked;
  const int answered = ways_->answered;

  for (int i = 0; i < kCalls; ++i) ASSERT_EQ(user->get_move(move), Status(Status::kDone));

  const int expected = HasAShorterWay() ? kCalls : 0;
  EXPECT_EQ(ways_->asked - asked, expected);
  EXPECT_EQ(ways_->answered - answered, expected);
}

TEST_P(WayOfAnswers, WhoWaitsForACommandAsksByTheShorterWay) {
  const int asked = ways_->asked;
  const int answered = ways_->answered;
  for (int i = 0; i < kCalls; ++i) {
    ASSERT_EQ(user->move_to.Wait({}, std::chrono::seconds(20)), Status(Status::kDone));
  }

  // But where the network thread was just at it, and where the machine stood still for half a
  // second.
  EXPECT_EQ(ways_->asked > asked, HasAShorterWay());
  EXPECT_EQ(ways_->answered > answered, HasAShorterWay());
}

TEST_P(WayOfAnswers, AReadByAMethodIsAnsweredByTheShorterWayToo) {
  const int answered = ways_->answered;
  std::uint64_t answer = 0;

  for (int i = 0; i < kCalls; ++i) {
    ASSERT_TRUE(EventuallyTrue([&] { return user->ask(answer) == Status(Status::kDone); }));
  }

  EXPECT_EQ(ways_->answered > answered, HasAShorterWay());
}

TEST_P(WayOfAnswers, WhatNobodyWaitsForIsSent) {
  const int sent = ways_->sent;
  const int asked = ways_->asked;
  for (int i = 0; i < kCalls; ++i) ASSERT_TRUE(EventuallyQueued([&] { return user->stop(); }));

  EXPECT_TRUE(EventuallyTrue([&] { return ways_->sent > sent; }));
  EXPECT_EQ(ways_->asked, asked);
}

}  // namespace
