#include <gtest/gtest.h>
#include <tendon/base/os/process.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <algorithm>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "core/process/connections/holding_middleware.h"
#include "core/process/connections/remote_connection.h"

namespace {

using tendon::Channel;
using tendon::ConnectionState;
using tendon::Process;

constexpr std::chrono::seconds kLongEnoughToAnswer(120);

/// Process desk, whose links can be delayed by the test, and a client that sends requests to desk.
class HungPeers : public RemoteConnection {
 protected:
  HungPeers() {
    auto options = Options();
    gcm_address_ = options.gcm;
    options.middleware = links_;
    desk = std::make_unique<Process>("desk", options);
    desk->Add<plant::Plant>("plant");
    user = &desk->Add<plant::Operator>("operator");
    EXPECT_TRUE(desk->StartAll().ok());
    EXPECT_TRUE(desk->WaitUntilJoined(kLongEnoughToAnswer).ok());
    const auto channel =
        Channel::Open(*asking_, desk->address(),
                      {.instance = tendon::os::RandomNumber(),
                       .name = "asker",
                       .cookie = *tendon::LoopbackCookie()},
                      std::make_shared<tendon::ChannelHandler>(), kLongEnoughToAnswer);
    EXPECT_TRUE(channel.ok()) << channel.error().message;
    channel_ = *channel;
  }
  ~HungPeers() override {
    for (const std::string& address : held_) links_->Release(address);
  }

  void Hold(const std::string& address) {
    held_.push_back(address);
    links_->Hold(address);
  }
  /// Starts peers to which desk is connected. The peers hang after desk has lost their links.
  void LetPeersHang(std::size_t count) {
    std::vector<std::unique_ptr<Process>> peers;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string number = std::to_string(i);
      peers.push_back(Start("peer" + number));
      peers.back()->Add<plant::Plant>("plant");
      desk->Add<plant::Operator>("operator" + number);
      ASSERT_TRUE(desk->Connect({"desk", "operator" + number, "Robot"},
                                {"peer" + number, "plant", "Control"})
                      .ok());
    }
    ASSERT_TRUE(EventuallyActive(*desk, count));
    KillGcm();  // the GCM would report that the peers have left
    for (const auto& peer : peers) Hold(peer->address());
  }
  [[nodiscard]] bool IsWaitingForAPeer() const { return !links_->waiting().empty(); }

  /// Expects a reply to a request that desk executes in its worker.
  void ExpectThatDeskAnswers() {
    const auto fill = channel_->Call<tendon::MailboxFill>(
        tendon::message::kGetFill, 0, tendon::message::GetFill{"operator"}, kLongEnoughToAnswer);
    EXPECT_TRUE(fill.ok()) << fill.error().message;
    const auto rows = channel_->Call<tendon::message::SubscribeReply>(
        tendon::message::kSubscribe, 0,
        tendon::message::Subscribe{.component = "plant", .table = "state", .columns = {}},
        kLongEnoughToAnswer);
    EXPECT_TRUE(rows.ok()) << rows.error().message;
    tendon::message::OpenInterface open{.required = {"asker", "operator", "Robot"},
                                        .provided = {"desk", "plant", "Control"},
                                        .handle = 1,
                                        .capacity = 64};
    open.description.name = "Robot";
    const auto opened = channel_->Call<tendon::message::OpenInterfaceReply>(
        tendon::message::kOpenInterface, 0, open, kLongEnoughToAnswer);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
  }

  const std::shared_ptr<HoldingMiddleware> links_ =
      std::make_shared<HoldingMiddleware>(NewMiddleware());
  const std::shared_ptr<tendon::Middleware> asking_ = NewMiddleware();
  std::string gcm_address_;
  std::shared_ptr<Channel> channel_;

 private:
  std::vector<std::string> held_;
};

TEST_P(HungPeers, DoNotDelayServiceToOthers) {
  ASSERT_NO_FATAL_FAILURE(LetPeersHang(4));
  ASSERT_TRUE(EventuallyTrue([this] { return IsWaitingForAPeer(); }));

  ExpectThatDeskAnswers();

  EXPECT_TRUE(IsWaitingForAPeer());
}

TEST_P(HungPeers, IncludingTheGcmDoNotDelayService) {
  Hold(gcm_address_);
  KillGcm();
  ASSERT_TRUE(links_->EventuallyWaitedFor(gcm_address_));

  ExpectThatDeskAnswers();

  EXPECT_TRUE(links_->IsWaitedFor(gcm_address_));
}

TEST_P(HungPeers, DoNotDelayTheEndOfAProcess) {
  ASSERT_NO_FATAL_FAILURE(LetPeersHang(2));
  ASSERT_TRUE(EventuallyTrue([this] { return IsWaitingForAPeer(); }));

  auto ended = std::async(std::launch::async, [this] { desk.reset(); });

  EXPECT_EQ(ended.wait_for(kLongEnoughToAnswer), std::future_status::ready);
}

TEST_P(HungPeers, DelayOtherConnectionAttemptsUntilTheyTimeOut) {
  StartRobot();
  const auto hung = Start("hung");
  desk->Add<plant::Operator>("other");
  Hold(hung->address());

  ASSERT_TRUE(desk->Connect({"desk", "other", "Robot"}, {"hung", "plant", "Control"}).ok());
  ASSERT_TRUE(links_->EventuallyWaitedFor(hung->address()));

  const auto waiting = desk->Connect(kRobot, kControl);

  ASSERT_TRUE(waiting.ok()) << waiting.error().message;
  const auto all = desk->connections();
  const auto found = std::ranges::find(all, *waiting, &tendon::ConnectionDescription::id);
  ASSERT_NE(found, all.end());
  EXPECT_EQ(found->state, ConnectionState::kPending);
  EXPECT_EQ(found->reason, "process 'robot' has not answered yet");

  links_->TimeOut(hung->address());
  EXPECT_TRUE(
      EventuallyTrue([&] { return user->stop() == tendon::Status(tendon::Status::kQueued); }));
}

INSTANTIATE_TEST_SUITE_P(Over, HungPeers, testing::ValuesIn(NetworkKinds()), NameOfNetwork);

}  // namespace
