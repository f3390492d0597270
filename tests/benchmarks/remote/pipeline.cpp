#include <benchmarks/remote/pipeline.h>
#include <tendon/ice/ice_middleware.h>
#include <tendon/interface/offer.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/executing_calls.h>

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace tendon::benchmark {
namespace {

class Pipeline {
 public:
  Pipeline(std::uint64_t calls, const BeginCall& begin) : calls_(calls), begin_(begin) {}

  void Begin() {
    {
      const std::scoped_lock lock(mutex_);
      if (begun_ == calls_) return;
      ++begun_;
    }
    begin_([this](bool ok) { OnEnd(ok); });
  }
  /// Waits until all calls have ended. Returns true if none has failed.
  bool Wait() {
    std::unique_lock lock(mutex_);
    all_.wait(lock, [this] { return ended_ == calls_; });
    return !has_failed_;
  }

 private:
  void OnEnd(bool ok) {
    Begin();
    const std::scoped_lock lock(mutex_);
    if (!ok) has_failed_ = true;
    // With the lock held, because the waiter destroys this object.
    if (++ended_ == calls_) all_.notify_one();
  }

  const std::uint64_t calls_;
  const BeginCall& begin_;
  std::mutex mutex_;
  std::condition_variable all_;
  std::uint64_t begun_ = 0;
  std::uint64_t ended_ = 0;
  bool has_failed_ = false;
};

}  // namespace

void RunPipeline(std::uint64_t calls, std::uint64_t window, const BeginCall& begin) {
  Pipeline pipeline(calls, begin);
  for (std::uint64_t i = 0; i < std::min(calls, window); ++i) pipeline.Begin();
  Require(pipeline.Wait(), "a call has failed");
}

WaitingCalls::WaitingCalls(RemoteSystem& system, std::uint64_t window)
    : window_(window), middleware_(MakeIceMiddleware(Exposure::kLoopbackOnly)) {
  auto channel = Channel::Open(*middleware_, system.addresses().robot, NewHello("pipeline"),
                               std::make_shared<ChannelHandler>(), kTestTimeout);
  Require(channel.ok(), "the robot is not reached");
  channel_ = *std::move(channel);
  const auto opened = channel_->Call<message::OpenInterfaceReply>(
      message::kOpenInterface, 0,
      message::OpenInterface{.required = {"pipeline", "pipeline", "Robot"},
                             .provided = {"robot", "robot", "Control"},
                             .description = {.name = "Robot",
                                             .functions = {DescribeMember<Argument, None>(
                                                 "Move", CommandKind::kWrite)},
                                             .event_handlers = {}},
                             .handle = 1,
                             .capacity = static_cast<std::uint32_t>(2 * window)},
      kTestTimeout);
  Require(opened.ok(), "the robot is not connected");
  handle_ = opened->handle + 1;
  Encode(Argument{}, question_);
  AppendTimeout(kTestTimeout, question_);
}

WaitingCalls::~WaitingCalls() { channel_->Close(); }

void WaitingCalls::Run(std::uint64_t calls) {
  RunPipeline(calls, window_, [this](std::function<void(bool ok)> done) {
    channel_->Request(message::kWait, handle_, question_, kTestTimeout,
                      [done = std::move(done)](const Result<Bytes>& reply) {
                        done(reply.ok() && reply->size() > 0 &&
                             reply->back() == static_cast<std::byte>(Status::kDone));
                      });
  });
}

}  // namespace tendon::benchmark
