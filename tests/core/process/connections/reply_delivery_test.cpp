#include <gtest/gtest.h>

#include <atomic>
#include <optional>
#include <span>
#include <utility>

#include "core/process/connections/remote_connection.h"

namespace {

using tendon::Bytes;
using tendon::Status;

/// Counts the frames that arrive at a process, and the replies to them.
struct FrameCounts {
  std::atomic<int> sent{0};
  std::atomic<int> asked{0};     // direct frames
  std::atomic<int> answered{0};  // direct replies
};

/// A reply that is counted when it ends, at once or deferred.
class CountedReply final : public tendon::ReplySlot {
 public:
  CountedReply(tendon::ReplySlot& answer, std::shared_ptr<FrameCounts> counts)
      : answer_(answer), counts_(std::move(counts)) {}
  CountedReply(std::unique_ptr<tendon::ReplySlot> later, std::shared_ptr<FrameCounts> counts)
      : later_(std::move(later)), answer_(*later_), counts_(std::move(counts)) {}

 private:
  std::optional<std::span<std::byte>> MakeRoom(const tendon::FrameHeader& header) override {
    return answer_.Begin(header);
  }
  void OnEnd() override {
    ++counts_->answered;  // before the caller continues
    answer_.End();
  }
  std::unique_ptr<tendon::ReplySlot> MakeDeferred() override {
    auto later = answer_.Defer();
    return later ? std::make_unique<CountedReply>(std::move(later), counts_) : nullptr;
  }

  const std::unique_ptr<tendon::ReplySlot> later_;
  tendon::ReplySlot& answer_;
  const std::shared_ptr<FrameCounts> counts_;
};

/// A middleware that counts the frames of the links that it accepts.
class CountingMiddleware final : public tendon::Middleware {
 public:
  CountingMiddleware(std::shared_ptr<tendon::Middleware> below, std::shared_ptr<FrameCounts> counts)
      : below_(std::move(below)), counts_(std::move(counts)) {}

  [[nodiscard]] std::string_view name() const override { return below_->name(); }
  tendon::Result<std::unique_ptr<tendon::Listener>> Listen(const std::string& address,
                                                           tendon::AcceptLink accept) override {
    return below_->Listen(
        address,
        [accept = std::move(accept), counts = counts_](
            const std::shared_ptr<tendon::Link>& link) -> std::shared_ptr<tendon::LinkHandler> {
          auto handler = accept(link);
          if (!handler) return nullptr;
          return std::make_shared<CountingHandler>(std::move(handler), counts);
        });
  }
  tendon::Result<std::shared_ptr<tendon::Link>> Open(const std::string& address,
                                                     std::shared_ptr<tendon::LinkHandler> handler,
                                                     std::chrono::milliseconds timeout) override {
    return below_->Open(address, std::move(handler), timeout);
  }

 private:
  class CountingHandler final : public tendon::LinkHandler {
   public:
    CountingHandler(std::shared_ptr<tendon::LinkHandler> handler,
                    std::shared_ptr<FrameCounts> counts)
        : handler_(std::move(handler)), counts_(std::move(counts)) {}
    void OnFrame(std::span<const std::byte> frame) override {
      ++counts_->sent;
      handler_->OnFrame(frame);
    }
    void OnDirectFrame(std::span<const std::byte> frame, tendon::ReplySlot& answer) override {
      ++counts_->asked;
      CountedReply counted(answer, counts_);
      handler_->OnDirectFrame(frame, counted);
    }
    void OnClosed(const tendon::Error& reason) override { handler_->OnClosed(reason); }

   private:
    const std::shared_ptr<tendon::LinkHandler> handler_;
    const std::shared_ptr<FrameCounts> counts_;
  };

  const std::shared_ptr<tendon::Middleware> below_;
  const std::shared_ptr<FrameCounts> counts_;
};

/// A robot that counts frames, and a desk that calls its plant.
class ReplyDelivery : public RemoteConnection {
 protected:
  ReplyDelivery() {
    auto options = Options();
    options.middleware = std::make_shared<CountingMiddleware>(options.middleware, counts_);
    robot = std::make_unique<tendon::Process>("robot", options);
    plant = &robot->Add<plant::Plant>("plant");
    EXPECT_TRUE(robot->WaitUntilJoined(std::chrono::seconds(20)).ok());
    EXPECT_TRUE(robot->StartAll().ok());
    StartDesk();
    Connect();
  }
  [[nodiscard]] static bool HasDirectDelivery() { return GetParam().name != "tcp"; }

  const std::shared_ptr<FrameCounts> counts_ = std::make_shared<FrameCounts>();
};

INSTANTIATE_TEST_SUITE_P(Over, ReplyDelivery, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

constexpr int kCalls = 20;

TEST_P(ReplyDelivery, AReadUsesDirectDeliveryIfAvailable) {
  plant::Move move;
  ASSERT_TRUE(EventuallyTrue([&] { return user->get_move(move) == Status(Status::kDone); }));
  const int asked = counts_->asked;
  const int answered = counts_->answered;

  int calls = 0;  // including those that time out on a machine that stalls
  for (int i = 0; i < kCalls; ++i) {
    ASSERT_TRUE(EventuallyTrue([&] {
      ++calls;
      return user->get_move(move) == Status(Status::kDone);
    }));
  }

  if (!HasDirectDelivery()) calls = 0;
  EXPECT_TRUE(EventuallyTrue(
      [&] { return counts_->asked - asked >= calls && counts_->answered - answered >= calls; }));
  EXPECT_TRUE(HasDirectDelivery() || (counts_->asked == asked && counts_->answered == answered));
}

TEST_P(ReplyDelivery, AWaitedCommandUsesDirectDelivery) {
  const int asked = counts_->asked;
  const int answered = counts_->answered;
  for (int i = 0; i < kCalls; ++i) {
    ASSERT_EQ(user->move_to.Wait({}, std::chrono::seconds(20)), Status(Status::kDone));
  }

  // Some calls may use no direct frame: the network thread may send them, or the machine may stall.
  EXPECT_EQ(counts_->asked > asked, HasDirectDelivery());
  EXPECT_EQ(counts_->answered > answered, HasDirectDelivery());
}

TEST_P(ReplyDelivery, AMethodReadUsesDirectDelivery) {
  const int answered = counts_->answered;
  std::uint64_t answer = 0;

  for (int i = 0; i < kCalls; ++i) {
    ASSERT_TRUE(EventuallyTrue([&] { return user->ask(answer) == Status(Status::kDone); }));
  }

  EXPECT_EQ(counts_->answered > answered, HasDirectDelivery());
}

TEST_P(ReplyDelivery, AQueuedCommandUsesNoDirectDelivery) {
  const int sent = counts_->sent;
  const int asked = counts_->asked;
  for (int i = 0; i < kCalls; ++i) ASSERT_TRUE(EventuallyQueued([&] { return user->stop(); }));

  EXPECT_TRUE(EventuallyTrue([&] { return counts_->sent > sent; }));
  EXPECT_EQ(counts_->asked, asked);
}

}  // namespace
