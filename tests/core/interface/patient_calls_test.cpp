#include <gtest/gtest.h>
#include <tendon/interface/execution/block_when_full.h>
#include <tendon/interface/inbox.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace tendon {
namespace {

class Nothing final : public Mailbox::Entry {
  void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {}
};

/// A mailbox with room for one, which is full.
class FullMailbox : public testing::Test {
 protected:
  FullMailbox() {
    inbox.SetAccepting(true);
    mailbox.Publish(mailbox.Claim(), nothing);
  }

  Nothing nothing;
  Inbox inbox;
  Mailbox& mailbox = inbox.Open(1, {}, CallerThreads::kOneThread);
};

TEST_F(FullMailbox, RefusesAtOnceAsEver) {
  EXPECT_EQ(mailbox.Claim(), nullptr);
  EXPECT_EQ(mailbox.refused(), 1U);
}

TEST_F(FullMailbox, GivesAPatientCallTheRoomThatTheServerMakes) {
  std::atomic<bool> waits = false;
  std::thread server([&] {
    while (!waits) std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));  // most likely it waits by then
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

TEST_F(FullMailbox, LetsAPatientCallGoOnceItIsClosed) {
  const BlockWhenFull patient;
  std::thread manager([this] { mailbox.Close(); });

  EXPECT_EQ(mailbox.Claim(), nullptr);

  manager.join();
  EXPECT_EQ(mailbox.refusal(), Status(Status::kNotConnected));
}

TEST_F(FullMailbox, DoesNotHoldUpTheThreadThatWouldMakeTheRoom) {
  const BlockWhenFull patient;
  inbox.BindToThisThread();

  EXPECT_EQ(mailbox.Claim(), nullptr);

  EXPECT_LT(SteadyClock().Now(), BlockWhenFull::deadline()) << "it has waited";
}

TEST(BlockWhenFull, EndWithTheirScope) {
  EXPECT_EQ(BlockWhenFull::deadline(), SteadyTime::min());
  {
    const BlockWhenFull patient;
    EXPECT_GT(BlockWhenFull::deadline(), SteadyClock().Now());
  }
  EXPECT_EQ(BlockWhenFull::deadline(), SteadyTime::min());
}

}  // namespace
}  // namespace tendon
