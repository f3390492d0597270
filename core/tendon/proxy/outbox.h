#pragma once

#include <tendon/interface/inbox.h>
#include <tendon/interface/required_interface.h>
#include <tendon/lockfree/budget.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/call_batch.h>
#include <tendon/proxy/outstanding_calls.h>
#include <tendon/proxy/proxy_reports.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tendon {

/// Limits of an Outbox.
struct OutboxLimits {
  /// The largest number of calls that were sent but not executed yet.
  std::uint64_t credit = std::numeric_limits<std::uint64_t>::max();
  /// The largest number of argument bytes in the queue; a single larger argument is allowed. Calls
  /// whose callers wait do not count.
  std::uint64_t waiting_bytes = Budget<>::kNoLimit;
};

/// The queue of calls that will be sent on a channel. Component threads post the calls, and the
/// network thread sends them in order, many in one frame. A call whose caller waits is sent as a
/// request, in the same order. If no other call is queued, the caller's thread sends it directly.
///
/// If the link is full, no call is lost: the calls stay in the queue. If the mailbox is full,
/// callers get kQueueFull.
class Outbox {
 public:
  static constexpr std::uint64_t kAnyNumber = std::numeric_limits<std::uint64_t>::max();

  /// `interface` is the name of the interface in log messages.
  Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup,
         std::string interface, const OutboxLimits& limits = {});

  /// From now on, each call is sent with the time of the event that `source` handles. Must be
  /// called before the first call.
  void SendTimesOf(const RequiredInterface& source) { times_of_ = &source; }

  /// The queue of calls; it has one mailbox.
  [[nodiscard]] Inbox& inbox() { return inbox_; }

  /// Any thread: refuses later calls with kNotConnected, and ends the waiting of all callers.
  void Close();
  [[nodiscard]] bool is_open() const noexcept { return is_open_.Get(); }

  /// The lane on which calls are sent. Messages that must stay in order with the calls use the same
  /// lane.
  [[nodiscard]] Lane lane() const { return lane_; }

  /// Called when a value of a member is too large to be sent. The network thread logs this later.
  /// Any thread.
  void RefusePayload(std::uint32_t handle, std::size_t size) noexcept;
  [[nodiscard]] RefusedPayloads& refused_payloads() { return refused_payloads_; }

  /// The budget for the argument bytes in the queue. May be used in any thread.
  [[nodiscard]] Budget<>& waiting_bytes() { return waiting_bytes_; }

  /// Called when the first `calls` calls that were sent have been executed. If `calls` is greater
  /// than the number of sent calls, the next Send() closes the channel. Any thread.
  void SetExecuted(std::uint64_t calls);

  /// Returns true if some call was taken from the inbox but not sent, or was sent but may not be
  /// executed yet. Any thread.
  [[nodiscard]] bool HasCallsUnderWay() const;
  /// Any thread: returns true if a call is queued, or was taken from the inbox but not sent.
  [[nodiscard]] bool HasUnsent() const;

  /// The right of a thread to send. While a thread has this right, no other thread sends calls of
  /// this outbox.
  using Turn = std::unique_lock<std::mutex>;

  /// Network thread: sends queued calls, as many as `limit` and the credit allow, and returns their
  /// number.
  std::size_t Send(std::size_t limit = kAnyNumber);
  /// Sends the calls that the network thread took from the inbox but could not send. Tries for at
  /// most `timeout`. Must be called after the network thread has stopped using this object.
  void SendRest(std::chrono::milliseconds timeout);
  /// Network thread: returns true if the link was full or a caller is sending. Then Send() must be
  /// called again soon.
  [[nodiscard]] bool is_held_up() const {
    if (has_waited_) return true;
    const Turn turn(sending_, std::try_to_lock);
    return !turn || has_taken();
  }

  /// A call whose caller waits for the reply.
  struct BlockingCall {
    std::uint32_t handle = 0;
    Bytes argument;
    std::shared_ptr<OutstandingCalls<>> callers;
    std::uint64_t number = 0;  ///< number of the call in `callers`
  };

  /// Gives the calling thread the right to send. If other calls are already taken from the inbox,
  /// the credit is used up, or another thread is sending, the returned turn does not hold the lock,
  /// and the thread may not send.
  [[nodiscard]] Turn TakeTurn();
  /// Sends a call directly, without the mailbox, which must be empty. Returns the total number of
  /// sent calls, including this one. Returns 0 if the link is full; then the network thread will
  /// send the call.
  std::uint64_t SendNow(const Turn& turn, BlockingCall call);
  /// Called in the caller's thread when the reply to its call has arrived. `calls` is the number
  /// of this call among the sent calls. All earlier calls were executed too, because one mailbox
  /// keeps their order. Notifies the network thread if calls wait in `mailbox`.
  void OnExecuted(std::uint64_t calls, const Mailbox& mailbox);

  // Network thread: called by Send() with the next call from the inbox.

  void AddToBatch(std::uint32_t handle, std::span<const std::byte> argument) {
    if (times_of_ == nullptr) return batch_.Add(handle, argument);
    batch_.AddTimed(handle, argument, times_of_->event_time());
  }
  /// Sends the call from its buffer, without a copy, if it gets a frame of its own: a large call
  /// does, and a call after which no other is queued. If the link has no room, copies it into the
  /// batch. `mailbox` is the mailbox of the call, in which the call keeps its slot until then.
  void SendOrBatch(std::uint32_t handle, CallBuffer& call, const Mailbox& mailbox);
  void SetBlockingCall(BlockingCall call) { blocking_call_ = std::move(call); }

 private:
  [[nodiscard]] bool has_taken() const { return !batch_.empty() || blocking_call_; }
  [[nodiscard]] std::uint64_t Room() const;
  std::size_t SendTaken(std::size_t limit, Delivery delivery);
  void Collect(std::size_t limit);
  [[nodiscard]] bool SendBatch();
  [[nodiscard]] bool SendFrame(std::span<std::byte> frame, std::size_t calls);
  [[nodiscard]] Status Request(BlockingCall& call, Delivery delivery);

  const std::shared_ptr<Channel> channel_;
  const MessageType type_;
  const Lane lane_;
  Wakeup<>& wakeup_;
  RefusedPayloads refused_payloads_;
  const RequiredInterface* times_of_ = nullptr;
  Flag is_open_{true};
  Budget<> waiting_bytes_;
  Inbox inbox_;
  const std::uint64_t credit_;
  std::mutex raising_;  // protects executed_; reports may arrive out of order
  Published<std::uint64_t> executed_{0};

  // True if another thread held sending_ during the last Send(). Used in the network thread.
  bool has_waited_ = false;

  mutable std::mutex sending_;  // guards the members below
  std::uint64_t sent_ = 0;
  // Calls that were taken from the inbox, but not sent yet.
  CallBatch batch_;
  std::optional<BlockingCall> blocking_call_;  // sent after the batch
};

}  // namespace tendon
