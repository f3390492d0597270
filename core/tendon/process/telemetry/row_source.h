#pragma once

#include <tendon/base/backoff.h>
#include <tendon/base/clock.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/broadcast_messages.h>
#include <tendon/process/clock_offset.h>
#include <tendon/process/telemetry/make_telemetry_client.h>
#include <tendon/process/telemetry/past_rows_reading.h>
#include <tendon/process/telemetry/row_subscription.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The state of a topic that is being received. The receiving thread and the subscription share it.
/// Thread-safe.
class TopicState {
 public:
  /// From now on, batches belong to this activation of the subscription.
  void Begin(std::uint64_t beginning) {
    const std::scoped_lock lock(mutex_);
    beginning_ = beginning;
  }
  /// From now on, the subscription gets no batches.
  void End() { Begin(0); }

  /// While this object exists, a message is being handled.
  class MessageScope {
   public:
    explicit MessageScope(TopicState& topic) : topic_(topic) { topic_.SetBusy(true); }
    MessageScope(const MessageScope&) = delete;
    MessageScope& operator=(const MessageScope&) = delete;
    ~MessageScope() { topic_.SetBusy(false); }

   private:
    TopicState& topic_;
  };
  /// The number of the present activation; 0 while not active.
  [[nodiscard]] std::uint64_t beginning() const {
    const std::scoped_lock lock(mutex_);
    return beginning_;
  }
  /// The time since the last message; zero while the viewer is handling a message.
  [[nodiscard]] SteadyTime::duration silence() const {
    const std::scoped_lock lock(mutex_);
    return is_busy_ ? SteadyTime::duration(0) : SteadyClock().Now() - last_;
  }

 private:
  void SetBusy(bool is_busy) {
    const std::scoped_lock lock(mutex_);
    is_busy_ = is_busy;
    last_ = SteadyClock().Now();
  }

  mutable std::mutex mutex_;
  std::uint64_t beginning_ = 0;
  bool is_busy_ = false;
  SteadyTime last_ = SteadyClock().Now();
};

/// The viewer's channel to one process, and the subscriptions on this channel. The channel is open
/// while there are subscriptions. Lost subscriptions are requested again, with growing pauses of at
/// most a second.
///
/// Functions are called on the worker unless noted.
class RowSource final : public ChannelHandler, public std::enable_shared_from_this<RowSource> {
 public:
  /// The data for opening channels. It must outlive the worker.
  struct Access {
    std::shared_ptr<Middleware> middleware;
    ResolveAddress resolve;
    Hello hello;
    FindBroker find_broker{};
    std::chrono::milliseconds past_timeout{2000};  // of each request for kept rows
    // The time of the last failed subscription at a broker, by address; used only on the worker.
    std::shared_ptr<std::map<std::string, SteadyTime>> failed_brokers =
        std::make_shared<std::map<std::string, SteadyTime>>();
  };
  /// `pulse` pings the process even while the worker waits for another process.
  RowSource(const Access& access, std::shared_ptr<Worker> worker, std::shared_ptr<Worker> pulse,
            std::string process)
      : access_(access),
        past_timeout_(access.past_timeout),
        worker_(std::move(worker)),
        pulse_(std::move(pulse)),
        process_(std::move(process)) {}

  void Add(const std::shared_ptr<RowSubscription>& subscription);
  /// Unsubscribes at the process. RowSubscription::End() must have been called before.
  void Remove(const std::shared_ptr<RowSubscription>& subscription);
  /// Reads kept rows. The channel stays open until Close().
  void ReadPast(const std::shared_ptr<PastRowsReading>& reading);
  /// Tries to restore lost subscriptions at once.
  void Retry();
  /// Closes the channel. Call it after the worker has stopped.
  void Close();

 private:
  static constexpr std::chrono::milliseconds kShortestPause{100};
  static constexpr std::chrono::milliseconds kLongestPause{1000};

  enum class Stage { kWanted, kRequested, kActive };
  struct Item {
    std::shared_ptr<RowSubscription> subscription;
    Stage stage = Stage::kWanted;
    std::uint32_t handle = 0;
    bool is_direct = false;  // the broker has failed on this channel, so the process sends the rows
    std::shared_ptr<TopicState> line;  // set for rows from a topic, like the next member
    std::unique_ptr<Broadcast::Subscription> reception;
  };
  using SharedSubscription = std::shared_ptr<RowSubscription>;
  struct ActiveSubscription {
    std::shared_ptr<RowSubscription> subscription;
    std::uint64_t beginning = 0;
    std::shared_ptr<TopicState> line{};  // set for rows from a topic
  };

  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) override;
  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override;

  void RestoreAll();
  Result<void> Open(std::chrono::milliseconds timeout);
  void MeasureClock();
  /// Any thread.
  void AskForPastRows(const std::shared_ptr<Channel>& channel,
                      const std::shared_ptr<PastRowsReading>& reading);
  [[nodiscard]] ClockOffset clock();
  void Ask(Item& item);
  void RequestRows(Item& item);
  /// Returns the address of the broker if it supports this subscription; otherwise empty.
  [[nodiscard]] std::string BrokerFor(const Item& item) const;
  /// True if a subscription at the broker has failed recently.
  [[nodiscard]] bool HasFailedRecently(const std::string& broker) const;
  void RequestTopic(Item& item, const std::string& broker);
  void OnTopicJoined(const std::shared_ptr<Channel>& channel,
                     const SharedSubscription& subscription, const std::string& broker,
                     const Result<message::JoinTopicReply>& reply);
  Result<void> Follow(Item& item, const std::string& broker, const message::JoinTopicReply& joined);
  void MonitorTopic(const SharedSubscription& subscription,
                    const std::shared_ptr<TopicState>& line);
  void FallBack(Item& item, const Error& reason);
  /// Activates a subscription. Called in the middleware's thread.
  Result<void> Begin(Channel& channel, const std::shared_ptr<RowSubscription>& subscription,
                     const message::SubscribeReply& subscribed);
  void OnRows(Channel& channel, std::uint32_t handle, std::span<const std::byte> body);
  void OnReply(const std::shared_ptr<Channel>& channel,
               const std::shared_ptr<RowSubscription>& subscription,
               const Result<message::SubscribeReply>& reply);
  /// Ends a subscription at the process. Any thread.
  void Unsubscribe(Channel& channel, std::uint32_t handle);
  void RetryLater();
  Item* Find(const std::shared_ptr<RowSubscription>& subscription);
  std::shared_ptr<RowSubscription> Take(const Channel* channel, std::uint32_t handle);

  const Access& access_;  // used only on the worker, because a channel may outlive it
  const std::chrono::milliseconds past_timeout_;  // also used in the middleware's thread
  const std::shared_ptr<Worker> worker_;
  const std::shared_ptr<Worker> pulse_;
  const std::string process_;
  std::shared_ptr<Channel> channel_;
  std::vector<Item> items_;
  Backoff backoff_{kShortestPause, kLongestPause};
  bool is_retry_due_ = false;
  std::string fallen_back_;  // the logged reason for direct rows

  std::mutex mutex_;  // guards the members that the middleware's thread uses
  // The key includes the channel, because the end of an old channel may be reported after the next
  // channel was opened.
  std::map<std::pair<const Channel*, std::uint32_t>, ActiveSubscription> active_;
  ClockOffset clock_;  // the peer's clock
};

}  // namespace tendon
