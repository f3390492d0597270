#include <gmock/gmock.h>
#include <sys/mman.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

#include "conformance/contract.h"
#include "conformance/oracle.h"
#include "support/machine/sanitized.h"

namespace tendon::conformance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Returns a body in which no two parts are equal: the pattern has a prime length, so each part
/// begins at another position of the pattern.
Bytes Patterned(std::size_t size) {
  constexpr std::size_t kPeriod = 65'521;
  static const std::vector<std::uint32_t> words = [] {
    std::vector<std::uint32_t> all(kPeriod / sizeof(std::uint32_t) + 1);
    std::iota(all.begin(), all.end(), 1);
    return all;
  }();
  Bytes body(size);
  for (std::size_t begin = 0; begin < size; begin += kPeriod) {
    std::memcpy(body.data() + begin, words.data(), std::min(kPeriod, size - begin));
  }
  return body;
}

/// Keeps the notices, and answers a request with the request's own body. While Hold() is in effect,
/// it processes nothing more.
class Taker final : public ChannelHandler {
 public:
  struct Notice {
    std::uint32_t handle = 0;
    std::size_t size = 0;
    bool is_intact = false;
  };

  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> body, Responder responder) override {
    responder.Reply(body, kOwnLane);
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    const Bytes expected = Patterned(body.size());
    const bool is_intact = std::memcmp(body.data(), expected.data(), body.size()) == 0;
    const std::scoped_lock lock(mutex_);
    notices_.push_back({header.handle, body.size(), is_intact});
    changed_.notify_all();
  }
  void OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& /*reason*/) override {
    const std::scoped_lock lock(mutex_);
    is_closed_ = true;
    changed_.notify_all();
  }

  /// The handler blocks in the next notice until the lock is released.
  [[nodiscard]] std::unique_lock<std::mutex> Hold() { return std::unique_lock(mutex_); }

  std::vector<Notice> WaitForNotices(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, 3 * kTestTimeout,
                      [&] { return notices_.size() >= count || is_closed_; });
    return notices_;
  }
  bool WaitForClosed() {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, kTestTimeout, [&] { return is_closed_; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Notice> notices_;
  bool is_closed_ = false;
};

std::vector<std::uint32_t> HandlesOf(const std::vector<Taker::Notice>& notices) {
  std::vector<std::uint32_t> handles;
  for (const auto& notice : notices) handles.push_back(notice.handle);
  return handles;
}

constexpr std::size_t kLarge = std::size_t{3} << 20U;
constexpr std::size_t kSmall = 100;

/// Returns a size that takes longer to send than kLarge: the greatest, or less under a sanitizer,
/// which checks each byte.
std::size_t VeryLarge() { return test::IsSanitized() ? 4 * kLarge : kMaxPayload; }

constexpr std::size_t kMax = 1000 * kMaxPayload;

/// An address range without accessible memory: reading a byte of it ends the program.
class NobodysMemory {
 public:
  NobodysMemory()
      : begin_(mmap(nullptr, kMax, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {
    EXPECT_NE(begin_, MAP_FAILED);
  }
  NobodysMemory(const NobodysMemory&) = delete;
  NobodysMemory& operator=(const NobodysMemory&) = delete;
  ~NobodysMemory() { munmap(begin_, kMax); }

  [[nodiscard]] std::span<const std::byte> First(std::size_t size) const {
    return {static_cast<const std::byte*>(begin_), size};
  }

 private:
  void* const begin_;
};

/// The handlers at both ends of the channel.
struct Takers {
  std::shared_ptr<Taker> server = std::make_shared<Taker>();
  std::shared_ptr<Taker> client = std::make_shared<Taker>();
};

Status Notify(Channel& channel, std::uint32_t handle, std::size_t size, Lane lane = kCommonLane) {
  return channel.Notify(kTell, handle, Patterned(size), lane);
}

bool IsAlive(Channel& channel) { return channel.Call(kAsk, 0, Bytes(7), kLong).ok(); }

TEST_P(LargeMessageContract, ArrivesCompleteAtAnySize) {
  const Takers takers;
  Connect(takers.server, takers.client);
  const std::size_t sizes[] = {kMaxPieceSize - FrameHeader::kSize,
                               kMaxPieceSize - FrameHeader::kSize + 1,
                               2 * kPartSize - FrameHeader::kSize,
                               2 * kPartSize - FrameHeader::kSize + 1,
                               kLarge + 1,
                               kMaxPayload / 10 * 9,
                               kMaxPayload,
                               kMaxBodySize};

  std::size_t sent = 0;
  std::vector<Taker::Notice> notices;
  for (const std::size_t size : sizes) {
    // A sanitizer checks each byte, which takes too long.
    if (size > 2 * kLarge && test::IsSanitized()) continue;
    ++sent;
    ASSERT_EQ(Notify(*channel_, 1, size), Status::kQueued) << size;
    notices = takers.server->WaitForNotices(notices.size() + 1);
    ASSERT_FALSE(notices.empty());
    EXPECT_EQ(notices.back().size, size);
    EXPECT_TRUE(notices.back().is_intact) << size;
  }

  EXPECT_EQ(notices.size(), sent);
}

TEST_P(LargeMessageContract, OverTheLimitIsRefusedByTheSender) {
  const Takers takers;
  Connect(takers.server, takers.client);
  const std::size_t sizes[] = {kMaxBodySize + 1, kMaxPayload + kMaxPayload / 10, 10 * kMaxPayload,
                               kMax};
  const NobodysMemory memory;

  for (const std::size_t size : sizes) {
    const std::span body = memory.First(size);
    EXPECT_EQ(channel_->Notify(kTell, 0, body), Status::kInvalid) << size;
    const auto reply = channel_->Call(kAsk, 0, body, kLong);
    ASSERT_FALSE(reply.ok());
    EXPECT_EQ(reply.error().code, ErrorCode::kInvalid);
    EXPECT_THAT(reply.error().message, HasSubstr("exceeds max_payload 67 108 864 B"));
  }

  EXPECT_TRUE(IsAlive(*channel_));
}

TEST_P(LargeMessageContract, MessagesOfAnotherLaneOvertakeIt) {
  const Takers takers;
  Connect(takers.server, takers.client);
  const Lane lane = channel_->NewLane();
  const Lane other = channel_->NewLane();
  auto held = takers.server->Hold();
  ASSERT_EQ(Notify(*channel_, 0, kSmall), Status::kQueued);  // the handler blocks in this notice

  ASSERT_EQ(Notify(*channel_, 1, VeryLarge(), lane), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 2, kSmall), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 3, kSmall, other), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 4, kLarge, other), Status::kQueued);
  held.unlock();

  EXPECT_THAT(HandlesOf(takers.server->WaitForNotices(5)), ElementsAre(0, 2, 3, 4, 1));
}

TEST_P(LargeMessageContract, MessagesOfItsOwnLaneDoNotOvertakeIt) {
  const Takers takers;
  Connect(takers.server, takers.client);
  const Lane lane = channel_->NewLane();
  auto held = takers.server->Hold();
  ASSERT_EQ(Notify(*channel_, 0, kSmall), Status::kQueued);

  ASSERT_EQ(Notify(*channel_, 1, kLarge, lane), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 2, kSmall, lane), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 3, kLarge, lane), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 4, kSmall, lane), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 5, kSmall), Status::kQueued);
  held.unlock();

  const auto notices = takers.server->WaitForNotices(6);
  EXPECT_THAT(HandlesOf(notices), ElementsAre(0, 5, 1, 2, 3, 4));
  for (const auto& notice : notices) EXPECT_TRUE(notice.is_intact) << notice.handle;
}

TEST_P(LargeMessageContract, LargeMessagesOfOtherLanesOvertakeIt) {
  const Takers takers;
  Connect(takers.server, takers.client);
  auto held = takers.server->Hold();
  ASSERT_EQ(Notify(*channel_, 0, kSmall), Status::kQueued);

  ASSERT_EQ(Notify(*channel_, 1, VeryLarge(), kOwnLane), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 2, kLarge, kOwnLane), Status::kQueued);
  held.unlock();

  EXPECT_THAT(HandlesOf(takers.server->WaitForNotices(3)), ElementsAre(0, 2, 1));
}

TEST_P(LargeMessageContract, MayBeAReply) {
  const Takers takers;
  Connect(takers.server, takers.client);
  const Bytes question = Patterned(kLarge);

  const auto reply = channel_->Call(kAsk, 0, question, kLong);

  ASSERT_TRUE(reply.ok()) << reply.error().message;
  EXPECT_TRUE(std::ranges::equal(reply->body(), question));
}

TEST_P(LargeMessageContract, TravelsInBothDirectionsAtOnce) {
  const Takers takers;
  Connect(takers.server, takers.client);
  // Shared, because late replies may arrive after the test.
  const auto replies = std::make_shared<std::atomic<std::size_t>>(0);
  for (int i = 0; i < 2; ++i) {
    channel_->Request(kAsk, 0, Patterned(kLarge), 3 * kLong, [replies](Result<Bytes> reply) {
      if (reply && *reply == Patterned(kLarge)) ++*replies;
    });
  }

  EXPECT_TRUE(EventuallyTrue([&] { return *replies == 2; }));
}

TEST_P(LargeMessageContract, AFullWindowRefusesItButNotSmallMessages) {
  const Takers takers;
  Connect(takers.server, takers.client);
  auto held = takers.server->Hold();
  ASSERT_EQ(Notify(*channel_, 0, kSmall), Status::kQueued);

  std::uint32_t sent = 0;
  while (sent < 100 && Notify(*channel_, 1 + sent, kLarge, kOwnLane)) ++sent;
  EXPECT_EQ(sent, kSendWindow / kLarge);
  // One further message may be queued.
  EXPECT_EQ(Notify(*channel_, 90, VeryLarge(), kOwnLane), Status::kQueued);
  EXPECT_EQ(Notify(*channel_, 91, VeryLarge(), kOwnLane), Status::kQueueFull);
  EXPECT_EQ(Notify(*channel_, 92, kSmall), Status::kQueued);
  held.unlock();

  const auto notices = takers.server->WaitForNotices(sent + 3);
  ASSERT_EQ(notices.size(), sent + 3);
  EXPECT_EQ(notices[1].handle, 92U);
  EXPECT_EQ(notices.back().handle, 90U);
  EXPECT_TRUE(IsAlive(*channel_));
  EXPECT_EQ(Notify(*channel_, 93, VeryLarge(), kOwnLane), Status::kQueued);
  EXPECT_EQ(takers.server->WaitForNotices(sent + 4).size(), sent + 4);
}

TEST_P(LargeMessageContract, ClosingTheChannelDropsAnUnfinishedMessage) {
  const Takers takers;
  Connect(takers.server, takers.client);
  auto held = takers.server->Hold();
  ASSERT_EQ(Notify(*channel_, 0, kSmall), Status::kQueued);
  ASSERT_EQ(Notify(*channel_, 1, VeryLarge()), Status::kQueued);

  channel_->Close();
  held.unlock();

  ASSERT_TRUE(takers.server->WaitForClosed());
  ASSERT_TRUE(takers.client->WaitForClosed());
  EXPECT_EQ(takers.server->WaitForNotices(1).size(), 1U);
  EXPECT_EQ(Notify(*channel_, 2, kLarge), Status::kNotConnected);
}

TEST_P(LargeMessageContract, AMalformedPartClosesTheChannel) {
  const Takers takers;
  Connect(takers.server, takers.client);
  ASSERT_EQ(channel_->Notify(MessageType::kPart, 1, Bytes(kSmall)), Status::kQueued);

  EXPECT_TRUE(takers.server->WaitForClosed());
  EXPECT_TRUE(takers.client->WaitForClosed());
}

TEST_P(LargeMessageContract, AcknowledgingUnsentPartsClosesTheChannel) {
  const Takers takers;
  Connect(takers.server, takers.client);
  ASSERT_EQ(channel_->Notify(MessageType::kPartsTaken, 0, std::uint64_t{1}), Status::kQueued);

  EXPECT_TRUE(takers.server->WaitForClosed());
}

}  // namespace
}  // namespace tendon::conformance
