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
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace tendon {

/// Limits of an Outbox.
struct OutboxLimits {
  std::uint64_t credit = std::numeric_limits<std::uint64_t>::max();  ///< sent, not yet executed
  /// Bytes of arguments that may wait here; a single larger argument is allowed. Does not count
  /// calls whose callers wait.
  std::uint64_t waiting_bytes = Budget<>::kNoLimit;
};

/// The calls that wait to be sent on a channel. Component threads post them; the network thread
/// sends them in order, many in one frame. A call with a waiting caller is sent as a request, in
/// the same order; if nothing is queued, its caller sends it directly. No call is lost if the link
/// is full: calls wait here, and when the mailbox is full, callers get kQueueFull.
class Outbox {
 public:
  static constexpr std::uint64_t kAnyNumber = std::numeric_limits<std::uint64_t>::max();

  /// `interface` names the members' interface in the log.
  Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup,
         std::string interface, const OutboxLimits& limits = {});

  /// Sends each call with the time of the event of `source`. Must be called before the first call.
  void SendTimesOf(const RequiredInterface& source) { times_of_ = &source; }

  /// The queue of calls; it has one mailbox.
  [[nodiscard]] Inbox& inbox() { return inbox_; }

  /// Any thread: refuses later posts with kNotConnected and ends all waits.
  void Close();
  [[nodiscard]] bool is_open() const noexcept { return is_open_.Get(); }

  /// The lane on which calls are sent. Messages that must stay in order with them use it too.
  [[nodiscard]] Lane lane() const { return lane_; }

  /// Any thread, even a caller's: leaves a note that a value of a member is too large to be sent.
  void RefusePayload(std::uint32_t handle, std::size_t size) noexcept;
  [[nodiscard]] RefusedPayloads& refused_payloads() { return refused_payloads_; }

  /// The budget for the bytes that wait here. Any thread.
  [[nodiscard]] Budget<>& waiting_bytes() { return waiting_bytes_; }

  /// Any thread: at least `calls` of the sent calls were executed. If `calls` is greater than the
  /// number sent, the next Send() closes the channel.
  void SetExecuted(std::uint64_t calls);

  /// Any thread: true if calls wait to be sent, or are sent and not known to be executed.
  [[nodiscard]] bool HasCallsUnderWay() const;

  /// A caller's right to send: while it is held, no other thread sends from here.
  using Turn = std::unique_lock<std::mutex>;

  /// Network thread: sends waiting calls, up to `limit` and the credit, and returns their number.
  std::size_t Send(std::size_t limit = kAnyNumber);
  /// Call it after the network thread has stopped working here: sends the calls that it took and
  /// could not send, for at most `patience`.
  void SendRest(std::chrono::milliseconds patience);
  /// Network thread: true if the link was full or a caller is sending. Then Send() must be tried
  /// again soon.
  [[nodiscard]] bool is_held_up() const {
    if (has_waited_) return true;
    const Turn turn(sending_, std::try_to_lock);
    return !turn || has_taken();
  }

  /// A call whose caller waits.
  struct BlockingCall {
    std::uint32_t handle = 0;
    Bytes argument;
    std::shared_ptr<OutstandingCalls<>> callers;
    std::uint64_t number = 0;  ///< in `callers`
  };

  /// Returns a turn without the right to send if other calls are already taken, the credit is used
  /// up, or another thread is sending.
  [[nodiscard]] Turn TakeTurn();
  /// Sends a call without the mailbox, which must be empty. If the link is full, leaves the call to
  /// the network thread. Returns the total number of sent calls, including this one, or 0 if it was
  /// not sent yet.
  std::uint64_t SendNow(const Turn& turn, BlockingCall call);
  /// Called in a caller's thread: the first `calls` sent calls were executed. It is enough to know
  /// that the last of them was, because one mailbox keeps their order. Notifies the network thread
  /// if calls wait in the mailbox `callers`.
  void OnExecuted(std::uint64_t calls, const Mailbox& callers);

  // Network thread, called by Send(): takes the next call.

  void Take(std::uint32_t handle, std::span<const std::byte> argument) {
    if (times_of_ == nullptr) return batch_.Add(handle, argument);
    batch_.AddTimed(handle, argument, times_of_->event_time());
  }
  void Take(BlockingCall call) { blocking_call_ = std::move(call); }

 private:
  [[nodiscard]] bool has_taken() const { return !batch_.empty() || blocking_call_; }
  [[nodiscard]] std::uint64_t Room() const;
  std::size_t SendTaken(std::size_t limit, Delivery delivery);
  void Collect(std::size_t limit);
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
  std::mutex raising_;  // guards executed_: reports may arrive out of order
  Published<std::uint64_t> executed_{0};

  bool has_waited_ = false;  // network thread: another thread held sending_ in its last Send()

  mutable std::mutex sending_;  // guards the members below
  std::uint64_t sent_ = 0;
  // Calls taken from the inbox, but not sent.
  CallBatch batch_;
  std::optional<BlockingCall> blocking_call_;  // to be sent after the batch
};

}  // namespace tendon
