#include <benchmarks/remote/large_system.h>
#include <support/wait.h>
#include <tendon/gcm/client.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/middleware/channel.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace tendon::benchmark {
namespace {

using namespace std::chrono_literals;

struct Audience {
  int processes = 20;
  int watchers = 500;
  int questions = 1000;
};

/// Receives the changes of the catalogue and decodes them: a viewer without its other costs.
class Watcher final : public ChannelHandler {
 public:
  explicit Watcher(std::atomic<std::uint64_t>& notices) : notices_(notices) {}

  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> /*body*/) override {
    if (header.type == message::kChanges) ++notices_;
  }

 private:
  std::atomic<std::uint64_t>& notices_;
};

class Watchers {
 public:
  Watchers(const std::string& gcm, int count)
      : middleware_(MakeIceMiddleware(Exposure::kLoopbackOnly)) {
    for (int i = 0; i < count; ++i) {
      auto channel = Channel::Open(*middleware_, gcm, NewHello("watcher" + std::to_string(i)),
                                   std::make_shared<Watcher>(*notices_), kTestTimeout);
      Require(channel.ok(), "a watcher finds no GCM");
      Require((*channel)->Call(message::kWatch, 0, EncodeBody(None{}), kTestTimeout).ok(),
              "a watcher is not told what there is");
      channels_.push_back(*std::move(channel));
    }
  }
  Watchers(const Watchers&) = delete;
  Watchers& operator=(const Watchers&) = delete;
  ~Watchers() {
    for (const auto& channel : channels_) channel->Close();
  }

  /// The total number of changes that all watchers have received.
  [[nodiscard]] std::uint64_t notices() const { return *notices_; }

 private:
  const std::shared_ptr<std::atomic<std::uint64_t>> notices_ =
      std::make_shared<std::atomic<std::uint64_t>>(0);
  const std::shared_ptr<Middleware> middleware_;
  std::vector<std::shared_ptr<Channel>> channels_;
};

/// A process in which a component is added and removed about ten times per second.
class Restless {
 public:
  Restless(const RemoteSystem& system, const std::string& gcm)
      : process_("restless", {.middleware = system.Options().middleware, .gcm = gcm}) {
    Require(process_.WaitUntilJoined(kTestTimeout).ok(), "a process does not join");
    thread_ = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested()) {
        process_.Add<Desk>("desk");
        std::this_thread::sleep_for(50ms);
        Require(process_.Remove("desk").ok(), "a component does not go");
        std::this_thread::sleep_for(50ms);
      }
    });
  }

 private:
  Process process_;
  std::jthread thread_;
};

/// Returns the 99th percentile of the time of a request to the GCM, while all watchers receive the
/// changes.
double AskOften(const RemoteSystem& system, const Audience& audience) {
  LargeSystem large(system, audience.processes, 1);
  large.Join();
  GcmClient client(MakeIceMiddleware(Exposure::kLoopbackOnly), {.address = large.address()});
  Require(EventuallyTrue([&] { return client.WaitUntilWatching().ok(); }), "no GCM is there");
  const auto processes = static_cast<std::size_t>(audience.processes);
  Require(EventuallyTrue([&] { return client.catalogue().processes().size() == processes; }),
          "the processes do not join");
  const Watchers watchers(large.address(), audience.watchers);
  const Restless restless(system, large.address());
  Require(EventuallyTrue([&] { return watchers.notices() > 0; }), "nothing changes");

  std::vector<double> times;
  for (int i = 0; i < audience.questions; ++i) {
    const auto start = std::chrono::steady_clock::now();
    const auto health =
        Wait<message::SystemHealth>(kTestTimeout, [&](auto handler) { client.GetHealth(handler); });
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    Require(health.ok(), "the GCM does not answer");
    times.push_back(took.count());
    std::this_thread::sleep_for(5ms);
  }
  return Quantile(std::move(times), 0.99);
}

}  // namespace

std::vector<Case> QueryCases(const Effort& effort, const TheSystem& system) {
  const Audience audience = effort.is_tiny ? Audience{2, 10, 10} : Audience{};
  return {{.id = "G3",
           .what = "p99 of a question while 500 watch 20 processes",
           .stretch = 50e6,
           .repetition = [=] { return std::optional(Pair{.ours = AskOften(system(), audience)}); },
           .runs_once = true}};
}

}  // namespace tendon::benchmark
