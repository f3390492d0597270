#include <gtest/gtest.h>
#include <tendon/interface/execution/patient_calls.h>
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
  Mailbox& mailbox = inbox.Open(1, {}, Callers::kOneThread);
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

  const PatientCalls patient;
  waits = true;
  std::byte* const room = mailbox.Claim();

  server.join();
  ASSERT_NE(room, nullptr);
  EXPECT_EQ(mailbox.refused(), 0U);
  mailbox.Publish(room, nothing);
}

TEST_F(FullMailbox, LetsAPatientCallGoOnceItIsClosed) {
  const PatientCalls patient;
  std::thread manager([this] { mailbox.Close(); });

  EXPECT_EQ(mailbox.Claim(), nullptr);

  manager.join();
  EXPECT_EQ(mailbox.refusal(), Status(Status::kNotConnected));
}

TEST_F(FullMailbox, DoesNotHoldUpTheThreadThatWouldMakeTheRoom) {
  const PatientCalls patient;
  inbox.BindToThisThread();

  EXPECT_EQ(mailbox.Claim(), nullptr);

  EXPECT_LT(SteadyClock().Now(), PatientCalls::deadline()) << "it has waited";
}

TEST(PatientCalls, EndWithTheirScope) {
  EXPECT_EQ(PatientCalls::deadline(), SteadyTime::min());
  {
    const PatientCalls patient;
    EXPECT_GT(PatientCalls::deadline(), SteadyClock().Now());
  }
  EXPECT_EQ(PatientCalls::deadline(), SteadyTime::min());
}

}  // namespace
}  // namespace tendon
