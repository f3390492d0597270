#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>
#include <tendon/process/messages.h>
#include <tendon/process/server/mirrored_commands.h>
#include <tendon/process/telemetry/fan_out_messages.h>
#include <tendon/process/telemetry/table_feed.h>
#include <tendon/proxy/mirror/messages.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// Sends the rows of this process' state tables to viewers: every 20 ms what was written since,
/// gathered by the network thread, once for all who watch the same table.
///
/// Without a remark, functions are called on the worker.
class TelemetryServer final : public NetworkJob {
 public:
  explicit TelemetryServer(ProcessContext& context);
  ~TelemetryServer() override;

  /// What one viewer may have, by one channel, so that it is in nobody's way: so many
  /// subscriptions, and of one table so much that for each row all columns are read so often.
  /// Subscriptions of the same columns and rows are read once; what a process mirrors, which takes
  /// an operator's right, is not refused for its number.
  ///
  /// All viewers together have no bound: a few could use it up.
  static constexpr std::size_t kMostSubscriptions = 2048;
  static constexpr std::size_t kMostReadings = 32;

  /// Answers before the first row is sent; where the answer cannot be sent there is no
  /// subscription. Refusals: kNotFound with a suggestion; kInvalid for a period below zero, or a
  /// column named twice; kFailed for more than one viewer may have.
  void Subscribe(const std::shared_ptr<Channel>& channel, const message::Subscribe& wanted,
                 Responder& responder);
  /// The rows come by a topic of the broker. Refusals: also kNotFound where there is none, or the
  /// middleware has no way to it; kInvalid for what it cannot carry.
  void JoinTopic(const std::shared_ptr<Channel>& channel, const message::Subscribe& wanted,
                 Responder& responder);
  /// Sends copies of what read commands answer with. Refusals: kNotFound; kIncompatible for a
  /// command that does not answer with the newest value of a column; kInvalid for one named twice.
  void Mirror(const std::shared_ptr<Channel>& channel, const message::Mirror& wanted,
              Responder& responder);
  /// Of topics that are made from now on; empty where there is none.
  void SetBroker(const std::string& address);
  void Unsubscribe(const std::shared_ptr<Channel>& channel, std::uint32_t handle);
  /// Any thread.
  void OnRowTaken(const std::shared_ptr<Channel>& channel, std::uint32_t handle) {
    receipts_.Add(channel, handle);
  }

  /// Any thread: before the component goes; its viewers are told.
  void RemoveComponent(const std::string& component);

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  struct Source {
    const StateTable* table = nullptr;
    std::vector<std::size_t> columns;
    const Flag* enabled = nullptr;  // of the command that reads it, if it is one
  };

  [[nodiscard]] Result<void> HasRoomFor(const Source& source, const message::Subscribe& wanted,
                                        const Channel& viewer) const;
  [[nodiscard]] Result<void> FitsTopic(const message::Subscribe& wanted,
                                       const Source& source) const;
  [[nodiscard]] static message::Subscribed Describe(const Source& source);
  [[nodiscard]] Result<Source> LookUp(const message::Subscribe& wanted) const;
  [[nodiscard]] Result<std::vector<Source>> LookUp(const message::Mirror& wanted) const;
  TableFeed& FeedOf(const std::string& component, const StateTable& table);

  ProcessContext& context_;
  std::mutex mutex_;  // taken after the manager's lock
  std::list<TableFeed> feeds_;
  MirroredCommands mirrored_;
  ReceiptBox receipts_;
  std::string broker_;
  std::uint32_t last_handle_ = 0;
  SteadyTime next_gathering_{};
};

}  // namespace tendon
