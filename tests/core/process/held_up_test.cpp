#include <gtest/gtest.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/large_message_in_progress.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/heartbeat.h>
#include <tendon/process/membership/membership.h>
#include <tendon/proxy/connection_messages.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/process/empty_process.h"
#include "support/folder.h"
#include "support/machine/stall_meter.h"
#include "support/wait.h"

namespace {

using tendon::Bytes;
using tendon::Channel;
using tendon::FrameHeader;
using tendon::LargeMessageInProgress;
using tendon::LoopbackMiddleware;
using tendon::LoopbackNetwork;
using tendon::MessageType;
using tendon::ProcessContext;
using tendon::Status;
using tendon::Worker;

constexpr std::chrono::seconds kLongEnough(120);
constexpr std::size_t kLarge = std::size_t{5} << 20U;
// Enough questions and renewals to take much longer than the silence limit.
constexpr int kQuestions = 6;
constexpr int kRenewals = 10;

/// Answers pings. A test can block it in the handler of a notice.
class Answering final : public tendon::ChannelHandler {
 public:
  void OnRequest(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                 std::span<const std::byte> /*body*/, tendon::Responder responder) override {
    responder.Reply(tendon::EncodeBody(tendon::message::Pong{}));
  }
  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& /*header*/,
                std::span<const std::byte> /*body*/) override {
    ++heard_;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !is_held_; });
  }
  /// Returns the number of received notices.
  [[nodiscard]] int heard() const { return heard_; }
  void SetHeld(bool is_held) {
    const std::scoped_lock lock(mutex_);
    is_held_ = is_held;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_held_ = false;
  std::atomic<int> heard_ = 0;
};

/// A monitored channel. Its pings are counted, and can be dropped.
class MonitorPeer : public testing::Test {
 protected:
  MonitorPeer() {
    network_->SetFaultInjector([this](const tendon::loopback::Frame& frame) {
      const MessageType type = tendon::ReadFrameHeader(frame.bytes, frame.bytes.size())->type;
      if (type == MessageType::kPart && is_slow_) Carry(frame.bytes.size());
      if (type != tendon::message::kPing) return tendon::loopback::kPass;
      ++asked_;
      return are_lost_ ? tendon::loopback::kDrop : tendon::loopback::kPass;
    });
    auto listener = server_.Listen(
        "127.0.0.1:0", Channel::Acceptor({.instance = 1, .name = "robot", .cookie = 4711},
                                         [this] { return handler_; }));
    EXPECT_TRUE(listener.ok());
    listener_ = *std::move(listener);
    const auto channel = Channel::Open(client_, listener_->address(),
                                       {.instance = 2, .name = "desk", .cookie = 4711},
                                       std::make_shared<tendon::ChannelHandler>(), kLongEnough);
    EXPECT_TRUE(channel.ok());
    channel_ = *channel;
    tendon::MonitorPeer(worker_, channel_);
  }
  ~MonitorPeer() override { handler_->SetHeld(false); }

  /// Waits for `times` further pings while the channel is open.
  bool EventuallyAsked(
      int times, const std::function<void()>& meanwhile = [] {}) {
    const int before = asked_;
    return EventuallyTrue([&] {
      meanwhile();
      return asked_ >= before + times || !channel_->is_open();
    });
  }

  /// Takes as long as a line of 100 kB/s. The sending thread blocks like all frames behind it.
  static void Carry(std::size_t bytes) {
    std::this_thread::sleep_for(bytes * std::chrono::microseconds(10));
  }

  /// Succeeds if the channel is open, or if the machine stalled so long that the channel may have
  /// been closed.
  testing::AssertionResult IsKept() const {
    return channel_->is_open() || stalls_.has_stood_still() ? testing::AssertionSuccess()
                                                            : testing::AssertionFailure();
  }

  const tendon::test::StallMeter stalls_;
  std::atomic<int> asked_ = 0;
  std::atomic<bool> are_lost_ = false;
  std::atomic<bool> is_slow_ = false;
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server_{network_};
  LoopbackMiddleware client_{network_};
  const std::shared_ptr<Answering> handler_ = std::make_shared<Answering>();
  std::unique_ptr<tendon::Listener> listener_;
  std::shared_ptr<Channel> channel_;
  const std::shared_ptr<Worker> worker_ = std::make_shared<Worker>("timer", "test");
};

TEST_F(MonitorPeer, ClosesTheLinkToAHungPeer) {
  handler_->SetHeld(true);
  ASSERT_EQ(channel_->Notify(tendon::message::kCommands, 0, Bytes(8)), Status::kQueued);

  EXPECT_TRUE(EventuallyTrue([&] { return !channel_->is_open(); }));
}

TEST_F(MonitorPeer, AcknowledgedPartsCountAsSignsOfLife) {
  are_lost_ = true;

  const Bytes large(tendon::kMaxPieceSize + 1);
  int sent = 0;
  EXPECT_TRUE(EventuallyAsked(kQuestions, [&] {
    if (handler_->heard() < sent) return;
    sent += channel_->Notify(tendon::message::kCommands, 0, large) == Status::kQueued ? 1 : 0;
  }));

  EXPECT_TRUE(IsKept());
  EXPECT_TRUE(EventuallyTrue([&] { return !channel_->is_open(); })) << "they have ended";
}

TEST_F(MonitorPeer, ToleratesASlowLinkWithALargeMessage) {
  are_lost_ = true;
  is_slow_ = true;

  const Bytes large(tendon::kMaxPieceSize);
  ASSERT_EQ(channel_->Notify(tendon::message::kCommands, 0, large), Status::kQueued);

  EXPECT_TRUE(EventuallyTrue([&] { return handler_->heard() == 1 || !channel_->is_open(); }));
  EXPECT_TRUE(IsKept());
}

TEST_F(MonitorPeer, ToleratesSlowHandlingOfALargeMessage) {
  handler_->SetHeld(true);
  ASSERT_EQ(channel_->Notify(tendon::message::kCommands, 0, Bytes(kLarge)), Status::kQueued);

  EXPECT_TRUE(EventuallyAsked(kQuestions));

  EXPECT_TRUE(IsKept());
  handler_->SetHeld(false);
  if (!channel_->is_open()) return;
  EXPECT_TRUE(channel_->Call(tendon::message::kPing, 0, Bytes(), kLongEnough).ok());
}

TEST_F(MonitorPeer, ToleratesSilenceDuringLocalLargeMessages) {
  are_lost_ = true;
  std::optional<LargeMessageInProgress> large(std::in_place);

  EXPECT_TRUE(EventuallyAsked(kQuestions));

  EXPECT_TRUE(IsKept());
  large.reset();
  EXPECT_TRUE(EventuallyTrue([&] { return !channel_->is_open(); }));
}

TEST_F(MonitorPeer, DetectsAHungPeerDespiteConstantReads) {
  are_lost_ = true;

  EXPECT_TRUE(EventuallyTrue([&] {
    const LargeMessageInProgress read;
    return !channel_->is_open();
  }));
}

TEST(LargeMessageInProgress, ExcusesSilenceForALimitedTime) {
  const LargeMessageInProgress large;
  const tendon::SteadyTime now = tendon::SteadyClock().Now();

  EXPECT_EQ(LargeMessageInProgress::Last(now + LargeMessageInProgress::kShort),
            now + LargeMessageInProgress::kShort);
  EXPECT_LE(LargeMessageInProgress::Last(now + std::chrono::hours(1)),
            now + LargeMessageInProgress::kAtMost);
}

TEST(LargeMessageInProgress, ExcusesNothingIfItIsShort) {
  const auto leaves_no_trace = [] {
    const tendon::SteadyTime before = LargeMessageInProgress::Last(tendon::SteadyClock().Now());
    {
      const LargeMessageInProgress one;
      const LargeMessageInProgress another;
      if (LargeMessageInProgress::Last(tendon::SteadyClock().Now()) != before) return false;
    }
    return LargeMessageInProgress::Last(tendon::SteadyClock().Now()) == before;
  };

  EXPECT_TRUE(EventuallyTrue(leaves_no_trace)) << "unless this machine took its time";
}

/// A process without components, or with a component that repeatedly gets another large
/// configuration.
class Empty final : public EmptyProcess, public tendon::MembershipDelegate {
 public:
  [[nodiscard]] tendon::ProcessContent content() const override {
    if (!is_large) return {};
    tendon::ComponentDescription component;
    component.name = "cloud";
    component.configuration = '"' + std::string(tendon::kMaxPieceSize, 'x') + '"';
    component.warning = std::to_string(++asked);
    return {.components = {component}, .connections = {}, .plugins = {}};
  }
  void OnPeers(const std::vector<tendon::ProcessDescription>& /*processes*/) override {}
  void OnBroker(const std::string& /*address*/) override {}
  void OnOwnAddress(const std::string& /*address*/) override {}
  void MakeConnection(
      const tendon::message::ConnectionPlan& /*plan*/,
      std::function<void(const tendon::Result<tendon::ConnectionDescription>&)> done) override {
    done(Nothing());
  }
  tendon::Result<void> BreakConnection(const tendon::InterfaceName& /*required*/) override {
    return Nothing();
  }
  void ExecuteOrder(
      const tendon::message::LifecycleOrder& /*order*/,
      std::function<tendon::Result<void>()> /*begin*/,
      std::function<void(const tendon::Result<tendon::message::LifecycleOutcome>&)> done) override {
    done(Nothing());
  }
  void ListClasses(
      std::function<void(const tendon::Result<tendon::message::Classes>&)> done) override {
    done(Nothing());
  }

  std::atomic<bool> is_large = false;
  mutable std::atomic<int> asked = 0;
};

/// Blocks its thread until it is released.
class Idler final : public tendon::NetworkJob {
 public:
  bool Work(tendon::SteadyTime /*now*/, tendon::SteadyTime& /*next*/) override {
    std::unique_lock lock(mutex_);
    is_there_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return is_over_; });
    return false;
  }
  void AwaitWork() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return is_there_; });
  }
  void End() {
    const std::scoped_lock lock(mutex_);
    is_over_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_there_ = false;
  bool is_over_ = false;
};

/// A member of a GCM. Its lease renewals are counted, and their replies can be dropped.
class Lease : public testing::Test {
 protected:
  Lease() {
    network_->SetFaultInjector([this](const tendon::loopback::Frame& frame) {
      const MessageType type = tendon::ReadFrameHeader(frame.bytes, frame.bytes.size())->type;
      if (type == tendon::message::kRenew) {
        ++renewals_;
        if (are_renewals_lost_) return tendon::loopback::kDrop;
      }
      const bool is_lost = are_answers_lost_ && type == MessageType::kReply;
      return is_lost ? tendon::loopback::kDrop : tendon::loopback::kPass;
    });
    auto gcm = tendon::GlobalManager::Start(std::make_shared<LoopbackMiddleware>(network_),
                                            {.state_folder = folder_.path()});
    EXPECT_TRUE(gcm.ok()) << gcm.error().message;
    gcm_ = *std::move(gcm);
    member_ = std::make_unique<tendon::Membership>(
        context_, process_,
        tendon::Membership::Options{.gcm = gcm_->address(), .process = {.name = "robot"}});
    member_->Begin();
    const auto joined = member_->WaitUntilJoined(kLongEnough);
    EXPECT_TRUE(joined.ok()) << joined.error().message;
  }
  ~Lease() override {
    context_.gcm_opener->Stop();
    context_.worker->Stop();
  }

  bool EventuallyRenewed(int times) {
    const int before = renewals_;
    return EventuallyTrue([&] { return renewals_ >= before + times; });
  }
  /// Returns the state of the process in the GCM's catalogue.
  [[nodiscard]] tendon::ProcessState state() const {
    return gcm_->catalogue().FindProcess("robot")->process.state;
  }

  const tendon::test::StallMeter stalls_;
  std::atomic<int> renewals_ = 0;
  std::atomic<bool> are_renewals_lost_ = false;
  std::atomic<bool> are_answers_lost_ = false;
  const tendon::test::Folder folder_;
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  std::unique_ptr<tendon::GlobalManager> gcm_;
  Empty process_;
  ProcessContext context_{
      .name = "robot",
      .process = process_,
      .middleware = std::make_shared<LoopbackMiddleware>(network_),
      .hello = {.instance = 1, .name = "robot", .cookie = *tendon::LoopbackCookie()},
      .worker = std::make_shared<Worker>("process", "robot"),
      .gcm_opener = std::make_shared<Worker>("gcm opener", "robot"),
      .network = std::make_shared<tendon::NetworkThread>(),
      .proxies = tendon::ComponentProxies(nullptr)};
  std::unique_ptr<tendon::Membership> member_;
};

TEST_F(Lease, IsRenewedWhileTheNetworkThreadCopies) {
  Idler copying;
  context_.network->Add(copying);
  copying.AwaitWork();

  EXPECT_TRUE(EventuallyRenewed(kRenewals));

  EXPECT_TRUE(member_->is_joined() || stalls_.has_stood_still());
  EXPECT_TRUE(EventuallyTrue([&] { return state() == tendon::ProcessState::kAlive; }));
  copying.End();
  context_.network->Remove(copying);
}

TEST_F(Lease, IsKeptByBothEndsDuringALargeMessage) {
  process_.is_large = true;
  are_renewals_lost_ = true;

  const int before = renewals_;
  int reported = before;
  EXPECT_TRUE(EventuallyTrue([&] {
    if (renewals_ > reported) member_->ReportSoon();
    reported = renewals_;
    return !member_->is_joined() || renewals_ >= before + kRenewals;
  }));

  EXPECT_TRUE(member_->is_joined() || stalls_.has_stood_still());
  EXPECT_TRUE(state() != tendon::ProcessState::kLost || stalls_.has_stood_still());
  process_.is_large = false;
  EXPECT_TRUE(EventuallyTrue([&] { return !member_->is_joined(); })) << "nothing more is renewed";
}

TEST_F(Lease, IsKeptWhileRepliesWaitBehindALargeMessage) {
  std::optional<LargeMessageInProgress> large(std::in_place);
  are_answers_lost_ = true;

  EXPECT_TRUE(EventuallyRenewed(kRenewals));

  EXPECT_TRUE(member_->is_joined() || stalls_.has_stood_still());
  EXPECT_TRUE(EventuallyTrue([&] { return state() == tendon::ProcessState::kAlive; }));
  large.reset();
  EXPECT_TRUE(EventuallyTrue([&] { return !member_->is_joined(); })) << "the GCM is silent";
}

}  // namespace
