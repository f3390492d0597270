#include <gtest/gtest.h>
#include <tendon/base/clock.h>
#include <tendon/interface/command.h>
#include <tendon/interface/execution/block_when_full.h>
#include <tendon/interface/inbox.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace tendon {
namespace {

class Nothing final : public Mailbox::Entry {
  void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {}
};

/// A full mailbox with room for one call.
struct FullBox {
  FullBox() {
    inbox.SetAccepting(true);
    mailbox.Publish(mailbox.Claim(), nothing);
  }

  Nothing nothing;
  Inbox inbox;
  Mailbox& mailbox = inbox.Open(1, {}, CallerThreads::kOneThread);
};

class FullMailbox : public testing::Test, protected FullBox {};

/// Repeats a call several times. Returns true if one of the calls ends before its deadline: on a
/// machine that stalls, single calls may miss the deadline.
bool EndsBeforeItsDeadline(const std::function<void()>& call) {
  for (int round = 0; round < 5; ++round) {
    const BlockWhenFull patient;
    call();
    if (SteadyClock().Now() < BlockWhenFull::deadline()) return true;
  }
  return false;
}

TEST_F(FullMailbox, RefusesAtOnceByDefault) {
  EXPECT_EQ(mailbox.Claim(), nullptr);
  EXPECT_EQ(mailbox.refused(), 1U);
}

TEST_F(FullMailbox, ABlockingCallWaitsForRoom) {
  std::atomic<bool> waits = false;
  std::thread server([&] {
    while (!waits) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the call probably waits by now
    inbox.BindToThisThread();
    EXPECT_EQ(inbox.ExecuteQueued(), 1U);
  });

  const BlockWhenFull patient;
  waits = true;
  std::byte* const room = mailbox.Claim();

  server.join();
  ASSERT_NE(room, nullptr);
  EXPECT_EQ(mailbox.refused(), 0U);
  mailbox.Publish(room, nothing);
}

TEST_F(FullMailbox, ClaimAtOnceWaitsInNoThread) {
  EXPECT_TRUE(EndsBeforeItsDeadline([this] { EXPECT_EQ(mailbox.ClaimAtOnce(), nullptr); }));

  EXPECT_GT(mailbox.refused(), 0U);
}

TEST_F(FullMailbox, ClosingItEndsABlockingCall) {
  EXPECT_TRUE(EndsBeforeItsDeadline([] {
    FullBox box;
    std::atomic<bool> waits = false;
    std::thread manager([&] {
      while (!waits) std::this_thread::yield();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));  // the call probably waits by now
      box.mailbox.Close();
    });

    waits = true;
    EXPECT_EQ(box.mailbox.Claim(), nullptr);

    manager.join();
    EXPECT_EQ(box.mailbox.refusal(), Status(Status::kNotConnected));
  }));
}

TEST_F(FullMailbox, DoesNotBlockItsOwnServerThread) {
  inbox.BindToThisThread();

  EXPECT_TRUE(EndsBeforeItsDeadline([this] { EXPECT_EQ(mailbox.Claim(), nullptr); }));
}

TEST(BlockWhenFull, EndsWithItsScope) {
  EXPECT_EQ(BlockWhenFull::deadline(), SteadyTime::min());
  {
    const BlockWhenFull patient;
    EXPECT_GT(BlockWhenFull::deadline(), SteadyClock().Now());
  }
  EXPECT_EQ(BlockWhenFull::deadline(), SteadyTime::min());
}

}  // namespace
}  // namespace tendon
