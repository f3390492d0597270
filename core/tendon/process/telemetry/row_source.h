#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/middleware/fan_out/fan_out.h>
#include <tendon/process/telemetry/clock_offset.h>
#include <tendon/process/telemetry/fan_out_messages.h>
#include <tendon/process/telemetry/row_subscription.h>
#include <tendon/process/telemetry/topic_line.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// A viewer's channel to one process, and its subscriptions there. Opened when there is one, closed
/// when there is none; what was lost is asked for again, ever more rarely, at least once a second.
///
/// Without a remark, functions are called on the worker.
class RowSource final : public ChannelHandler, public std::enable_shared_from_this<RowSource> {
 public:
  /// How channels are opened; outlives the worker.
  struct Access {
    std::shared_ptr<Middleware> middleware;
    ResolveAddress resolve;
    Hello hello;
    FindFanOut find_fan_out{};
    // When they last did not let us listen, by address; of the worker.
    std::shared_ptr<std::map<std::string, SteadyTime>> failed_brokers =
        std::make_shared<std::map<std::string, SteadyTime>>();
  };
  /// `pulse` shows the process that we live, while the worker waits for another one.
  RowSource(const Access& access, std::shared_ptr<Worker> worker, std::shared_ptr<Worker> pulse,
            std::string process)
      : access_(access),
        worker_(std::move(worker)),
        pulse_(std::move(pulse)),
        process_(std::move(process)) {}

  void Add(const std::shared_ptr<RowSubscription>& subscription);
  /// Ends it there; here it must have been ended before.
  void Remove(const std::shared_ptr<RowSubscription>& subscription);
  /// Tries again at once.
  void Retry();
  /// Once the worker has stopped.
  void Close();

 private:
  enum class Stage { kWanted, kAsked, kStanding };
  struct Item {
    std::shared_ptr<RowSubscription> subscription;
    Stage stage = Stage::kWanted;
    std::uint32_t handle = 0;
    bool is_direct = false;           // for the fan-out has failed it, on this channel
    std::shared_ptr<TopicLine> line;  // where the rows come by a topic, as the next
    std::unique_ptr<FanOut::Reception> reception;
  };
  using SharedSubscription = std::shared_ptr<RowSubscription>;
  struct Standing {
    std::shared_ptr<RowSubscription> subscription;
    std::uint64_t beginning = 0;
    std::shared_ptr<TopicLine> line{};  // where the rows come by a topic
  };

  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) override;
  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override;

  void Pursue();
  Result<void> Open();
  void MeasureClock();
  void Ask(Item& item);
  void AskDirectly(Item& item);
  /// Where there is a broker, and what is wanted goes by it.
  [[nodiscard]] std::string BrokerFor(const Item& item) const;
  /// It has just let somebody wait in vain.
  [[nodiscard]] bool MustRest(const std::string& broker) const;
  void AskForTopic(Item& item, const std::string& broker);
  void OnTopicJoined(const std::shared_ptr<Channel>& channel,
                     const SharedSubscription& subscription, const std::string& broker,
                     const Result<message::TopicJoined>& answer);
  Result<void> Follow(Item& item, const std::string& broker, const message::TopicJoined& joined);
  void WatchOverTopic(const SharedSubscription& subscription,
                      const std::shared_ptr<TopicLine>& line);
  void FallBack(Item& item, const Error& reason);
  /// In the middleware's thread.
  Result<void> Begin(Channel& channel, const std::shared_ptr<RowSubscription>& subscription,
                     const message::Subscribed& subscribed);
  void OnRows(Channel& channel, std::uint32_t handle, std::span<const std::byte> body);
  void OnAnswer(const std::shared_ptr<Channel>& channel,
                const std::shared_ptr<RowSubscription>& subscription,
                const Result<message::Subscribed>& answer);
  /// Any thread.
  void EndThere(Channel& channel, std::uint32_t handle);
  void RetryLater();
  Item* Find(const std::shared_ptr<RowSubscription>& subscription);
  std::shared_ptr<RowSubscription> Take(const Channel* channel, std::uint32_t handle);

  const Access& access_;  // on the worker only: a channel that is closed later may outlive it
  const std::shared_ptr<Worker> worker_;
  const std::shared_ptr<Worker> pulse_;
  const std::string process_;
  std::shared_ptr<Channel> channel_;
  std::vector<Item> items_;
  std::chrono::milliseconds pause_{0};
  bool is_retry_due_ = false;
  std::string fallen_back_;  // why, as it was logged

  std::mutex mutex_;  // of what the middleware's thread uses
  // By channel, too: the end of an old one may be heard when the next is open already.
  std::map<std::pair<const Channel*, std::uint32_t>, Standing> standing_;
  ClockOffset clock_;  // of the process at the other end
};

}  // namespace tendon
