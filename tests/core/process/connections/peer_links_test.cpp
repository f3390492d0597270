#include <gtest/gtest.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/connections/peer_links.h>

#include <atomic>
#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/process/connections/holding_middleware.h"
#include "core/process/empty_process.h"
#include "support/wait.h"

namespace {

using tendon::Channel;
using tendon::LoopbackMiddleware;
using tendon::LoopbackNetwork;
using tendon::PeerLink;
using tendon::Result;
using tendon::Worker;

/// Counts the links that it has lost.
class Lonely final : public tendon::ChannelHandler {
 public:
  void OnClosed(const std::shared_ptr<Channel>& /*channel*/,
                const tendon::Error& /*reason*/) override {
    ++lost;
  }
  std::atomic<int> lost = 0;
};

/// Processes that listen, and one process that opens links to them.
class OpenedPeerLinks : public testing::Test, private tendon::PeerListener {
 protected:
  /// Stops the worker here and not in the destructor: until then, the worker may call this
  /// listener.
  void TearDown() override {
    context_.opener->Stop();
    context_.worker->Stop();
    peers_.CloseAll();
  }

  /// Starts a new instance of a process, and returns its address.
  std::string Listen(const std::string& process, std::uint64_t instance) {
    auto listener = server_.Listen(
        "127.0.0.1:0", Channel::Acceptor({.instance = instance, .name = process, .cookie = kCookie},
                                         [lonely = lonely_] { return lonely; }));
    EXPECT_TRUE(listener.ok());
    listeners_.push_back(*std::move(listener));
    const std::string address = listeners_.back()->address();
    OnWorker([&] { peers_.Learn(process, address, instance); });
    return address;
  }
  std::string ListenAndHang(const std::string& process, std::uint64_t instance) {
    const std::string address = Listen(process, instance);
    links_->Hold(address);
    return address;
  }

  /// Requests a link. Returns true if the reply is still missing.
  bool AskFor(const std::string& process) {
    bool is_waiting = false;
    OnWorker([&] {
      outcomes_.erase(process);
      peers_.LinkTo(process, [this, process](const auto& link) {
        outcomes_.insert_or_assign(process, link);
      });
      is_waiting = !outcomes_.contains(process);
    });
    return is_waiting;
  }
  /// Repeats the request until the pause after a failure has ended.
  bool EventuallyAskedFor(const std::string& process) {
    return EventuallyTrue([&] { return AskFor(process); });
  }
  std::optional<Result<std::shared_ptr<PeerLink>>> Outcome(const std::string& process) {
    std::optional<Result<std::shared_ptr<PeerLink>>> outcome;
    OnWorker([&] {
      const auto found = outcomes_.find(process);
      if (found != outcomes_.end()) outcome = found->second;
    });
    return outcome;
  }
  bool EventuallyEnded(const std::string& process) {
    return EventuallyTrue([&] { return Outcome(process).has_value(); });
  }
  template <typename Task>
  void OnWorker(Task task) {
    std::promise<void> done;
    context_.worker->Post([&] {
      task();
      done.set_value();
    });
    done.get_future().wait();
  }

  static constexpr std::uint64_t kCookie = 4711;

  const std::shared_ptr<Lonely> lonely_ = std::make_shared<Lonely>();
  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server_{network_};
  std::vector<std::unique_ptr<tendon::Listener>> listeners_;
  const std::shared_ptr<HoldingMiddleware> links_ =
      std::make_shared<HoldingMiddleware>(std::make_shared<LoopbackMiddleware>(network_));
  EmptyProcess process_;
  tendon::ProcessContext context_{.name = "desk",
                                  .process = process_,
                                  .middleware = links_,
                                  .hello = {.instance = 1, .name = "desk", .cookie = kCookie},
                                  .worker = std::make_shared<Worker>("process", "desk"),
                                  .opener = std::make_shared<Worker>("opener", "desk"),
                                  .network = std::make_shared<tendon::NetworkThread>(),
                                  .proxies = tendon::ComponentProxies(nullptr)};
  tendon::PeerLinks peers_{context_, *this};

 private:
  void OnLinkClosed(const PeerLink& /*link*/, const tendon::Error& /*reason*/) override {}
  void OnInterfaceClosed(const PeerLink& /*link*/, std::uint32_t /*handle*/,
                         const tendon::Error& /*reason*/) override {}
  void OnServerChanged() override {}

  std::map<std::string, Result<std::shared_ptr<PeerLink>>> outcomes_;  // set by the worker
};

TEST_F(OpenedPeerLinks, ToSilentPeersComeLastAndOneByOne) {
  const std::string first = ListenAndHang("first", 2);
  const std::string second = ListenAndHang("second", 3);
  Listen("robot", 4);
  for (const auto& [process, address] : {std::pair("first", first), std::pair("second", second)}) {
    ASSERT_TRUE(AskFor(process));
    ASSERT_TRUE(links_->EventuallyWaitedFor(address));
    links_->TimeOut(address);
    ASSERT_TRUE(EventuallyEnded(process));
  }
  ASSERT_TRUE(EventuallyAskedFor("first"));
  ASSERT_TRUE(links_->EventuallyWaitedFor(first));
  ASSERT_TRUE(EventuallyAskedFor("second"));

  ASSERT_TRUE(AskFor("robot"));
  links_->TimeOut(first);

  ASSERT_TRUE(EventuallyEnded("robot"));
  EXPECT_TRUE(Outcome("robot")->ok());
  EXPECT_TRUE(links_->EventuallyWaitedFor(second));
}

TEST_F(OpenedPeerLinks, ReachAPeerAtItsNewAddress) {
  const std::string before = ListenAndHang("robot", 2);
  ASSERT_TRUE(AskFor("robot"));
  ASSERT_TRUE(links_->EventuallyWaitedFor(before));

  Listen("robot", 3);
  links_->TimeOut(before);

  ASSERT_TRUE(EventuallyEnded("robot"));
  const auto outcome = *Outcome("robot");
  ASSERT_TRUE(outcome.ok()) << outcome.error().message;
  EXPECT_EQ((*outcome)->instance(), 3U);
}

/// These processes accept links, but do not answer pings.
TEST_F(OpenedPeerLinks, ToLostPeersAreClosedOnceSilent) {
  Listen("robot", 2);
  (void)AskFor("robot");
  ASSERT_TRUE(EventuallyEnded("robot"));
  const auto outcome = *Outcome("robot");
  ASSERT_TRUE(outcome.ok()) << outcome.error().message;
  const std::shared_ptr<PeerLink> link = *outcome;
  const auto hear_of_the_gcm = [this] {
    OnWorker([this] {
      peers_.Update({});
      peers_.CloseOutdated();
    });
  };

  hear_of_the_gcm();
  if (link->silence() < std::chrono::milliseconds(500)) {
    EXPECT_TRUE(link->channel()->is_open()) << "it may be the GCM that is cut off from it";
  }
  ASSERT_TRUE(EventuallyTrue([&] { return link->silence() > std::chrono::seconds(1); }));
  hear_of_the_gcm();

  EXPECT_TRUE(EventuallyTrue([&] { return !link->channel()->is_open(); }));
}

TEST_F(OpenedPeerLinks, AreDroppedIfOpenedTooLate) {
  const std::string address = ListenAndHang("robot", 2);
  ASSERT_TRUE(AskFor("robot"));
  ASSERT_TRUE(links_->EventuallyWaitedFor(address));
  context_.worker->Stop();

  links_->Release(address);

  EXPECT_TRUE(EventuallyTrue([this] { return lonely_->lost == 1; }));
}

}  // namespace
