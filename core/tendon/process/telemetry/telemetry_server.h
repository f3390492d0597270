#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/broadcast_messages.h>
#include <tendon/process/context.h>
#include <tendon/process/history/process_history.h>
#include <tendon/process/mirrored_commands.h>
#include <tendon/process/telemetry/table_feed.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/connection_messages.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// Collects acknowledgements until the network thread sends rows the next time. In this way, a
/// single acknowledgement costs little. Thread-safe.
class AcknowledgementQueue {
 public:
  /// The maximum number of waiting acknowledgements of one viewer. It is twice the maximum number
  /// of subscriptions, because some subscriptions may just have ended.
  static constexpr std::size_t kMaxOfOneViewer = 4096;

  /// Adds an acknowledgement. Closes the channel of a viewer that exceeds the limit.
  void Add(const std::shared_ptr<Channel>& channel, std::uint32_t handle);
  /// Removes and returns all acknowledgements. Wait-free if none waits.
  [[nodiscard]] RowAcknowledgements TakeAll();

 private:
  Flag has_some_;
  std::mutex mutex_;
  RowAcknowledgements acknowledgements_;
};

/// Sends rows of this process's state tables to viewers. Every 20 ms the network thread reads the
/// new rows of each table once for all its viewers.
///
/// Functions are called on the worker unless noted.
class TelemetryServer final : public NetworkJob {
 public:
  TelemetryServer(ProcessContext& context, const ProcessHistory& history);
  ~TelemetryServer() override;

  /// The limits of one viewer, which is identified by its channel. They prevent a viewer from
  /// displacing other viewers. kMaxSubscriptions limits the number of its subscriptions.
  /// kMaxReadings limits the number of cells read per row of each table, as a multiple of the
  /// number of columns. Cells for several subscriptions to the same columns and rows are read once.
  /// The number of mirrors is not limited, because mirrors need the role of an operator.
  ///
  /// There is no common limit for all viewers, because a few viewers could exhaust it.
  static constexpr std::size_t kMaxSubscriptions = 2048;
  static constexpr std::size_t kMaxReadings = 32;

  /// Adds a subscription. Replies before the first row is sent. If the reply cannot be sent, does
  /// not add the subscription. Refusals: kNotFound with a suggestion; kInvalid for a period below
  /// zero, or a column named twice; kFailed above the limits of a viewer.
  void Subscribe(const std::shared_ptr<Channel>& channel, const message::Subscribe& wanted,
                 Responder& responder);
  /// Like Subscribe(), but the rows are published in a topic of the broker. Further refusals:
  /// kNotFound if there is no broker or the middleware does not support it; kInvalid for rows that
  /// a topic cannot carry.
  void JoinTopic(const std::shared_ptr<Channel>& channel, const message::Subscribe& wanted,
                 Responder& responder);
  /// Replies with rows that are already written and kept in the table or in the history, at most
  /// about 128 KiB. Refusals: kNotFound with a suggestion; kInvalid for a time below zero, or a
  /// column named twice; kFailed if the table was replaced after the first reply.
  void ReadRows(const message::ReadRows& wanted, Responder& responder) const;
  /// Starts to send copies of the values that read commands return. Refusals: kNotFound;
  /// kIncompatible for a command that does not return the newest value of a column; kInvalid for a
  /// command named twice.
  void Mirror(const std::shared_ptr<Channel>& channel, const message::Mirror& wanted,
              Responder& responder);
  /// Sets the broker for topics that are created from now on. An empty address means no broker.
  void SetBroker(const std::string& address);
  void Unsubscribe(const std::shared_ptr<Channel>& channel, std::uint32_t handle);
  /// Records that a viewer has received a row. Any thread.
  void OnRowTaken(const std::shared_ptr<Channel>& channel, std::uint32_t handle) {
    acknowledgements_.Add(channel, handle);
  }

  /// Ends the subscriptions to a component and notifies its viewers. Call it before the component
  /// is removed. Any thread.
  void RemoveComponent(const std::string& component);

  /// True if all rows that were written so far have been sent to the viewers. Any thread.
  [[nodiscard]] bool HasSentAll();

  bool Work(SteadyTime now, SteadyTime& next) override;

 private:
  struct Source {
    const StateTable* table = nullptr;
    std::vector<std::size_t> columns;
    const Flag* enabled = nullptr;  // flag of the read command; null for a plain column
  };

  [[nodiscard]] Result<void> HasRoomFor(const Source& source, const message::Subscribe& wanted,
                                        const Channel& viewer) const;
  [[nodiscard]] Result<void> FitsTopic(const message::Subscribe& wanted,
                                       const Source& source) const;
  [[nodiscard]] static message::SubscribeReply Describe(const Source& source);
  [[nodiscard]] Result<Source> LookUp(const message::Subscribe& wanted) const;
  [[nodiscard]] Result<std::vector<Source>> LookUp(const message::Mirror& wanted) const;
  TableFeed& FeedOf(const std::string& component, const StateTable& table);

  ProcessContext& context_;
  const ProcessHistory& history_;
  std::mutex mutex_;  // locked after the manager's lock
  std::list<TableFeed> feeds_;
  MirroredCommands mirrored_;
  AcknowledgementQueue acknowledgements_;
  std::string broker_;
  std::uint32_t last_handle_ = 0;
  SteadyTime next_gathering_{};
};

}  // namespace tendon
