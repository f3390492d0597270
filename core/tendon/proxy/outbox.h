#pragma once

#include <tendon/interface/inbox.h>
#include <tendon/interface/offer.h>
#include <tendon/interface/required_interface.h>
#include <tendon/lockfree/budget.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/proxy/call_batch.h>
#include <tendon/proxy/reports/refused_payloads.h>
#include <tendon/proxy/waiting/awaited_calls.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// How much may be on its way at a time.
struct OutboxLimits {
  std::uint64_t credit = std::numeric_limits<std::uint64_t>::max();  ///< calls under way
  /// Bytes of arguments that may wait here, but for one alone that may be larger; of calls for
  /// whose end nobody waits.
  std::uint64_t waiting_bytes = Budget<>::kNoLimit;
};

/// Calls that wait to be sent on a channel: posted in the thread of a component, sent in order by
/// the network thread, as many in one frame as wait, and those whose callers want an answer as
/// requests between them. Who wants an answer while nothing waits sends its call itself. What finds
/// the link full is kept, so that no call is lost; then the mailbox fills up, and its callers are
/// told.
class Outbox {
 public:
  static constexpr std::uint64_t kAnyNumber = std::numeric_limits<std::uint64_t>::max();

  /// `interface` is whose members are called, for the log.
  Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup,
         std::string interface, const OutboxLimits& limits = {});

  /// Before the first call: each is sent with the time of the event that `source` handles by it.
  void SendTimesOf(const RequiredInterface& source) { times_of_ = &source; }

  /// Where the calls wait; it has one mailbox.
  [[nodiscard]] Inbox& inbox() { return inbox_; }

  /// Any thread: what is posted from now on is refused with kNotConnected, and nobody waits here.
  void Close();
  [[nodiscard]] bool is_open() const noexcept { return is_open_.Get(); }

  /// In which calls are sent, in order: what else must keep it goes there as well.
  [[nodiscard]] Lane lane() const { return lane_; }

  /// Any thread, that of a caller too: a value of a member was refused, for it is too large.
  void RefusePayload(std::uint32_t handle, std::size_t size) noexcept;
  [[nodiscard]] RefusedPayloads& refused_payloads() { return refused_payloads_; }

  /// Of the bytes that may wait here. Any thread.
  [[nodiscard]] Budget<>& waiting_bytes() { return waiting_bytes_; }

  /// Any thread: at least so many of the calls that were sent have been executed. A peer that says
  /// so of more than were sent is cut off by the next Send().
  void SetExecuted(std::uint64_t calls);

  /// Any thread: whether calls were taken that are not sent, or sent and not known to be executed.
  [[nodiscard]] bool HasCallsUnderWay() const;

  /// The right to send, of a caller's thread: while it is held, nothing else is sent here.
  using Turn = std::unique_lock<std::mutex>;

  /// Network thread: sends what waits, at most `limit` calls and no more than may be under way;
  /// returns how many it sent.
  std::size_t Send(std::size_t limit = kAnyNumber);
  /// Instead of the network thread, once that does no work here any more: sends what it has taken
  /// and could not send, for at most `patience`.
  void SendRest(std::chrono::milliseconds patience);
  /// Network thread: whether the link was full, or a caller is just sending; try again soon.
  [[nodiscard]] bool is_held_up() const {
    if (has_waited_) return true;
    const Turn turn(sending_, std::try_to_lock);
    return !turn || has_taken();
  }

  /// A call whose caller waits.
  struct Question {
    std::uint32_t handle = 0;
    Bytes argument;
    std::shared_ptr<AwaitedCalls<>> callers;
    std::uint64_t call = 0;  ///< its number there
  };

  /// Nothing taken where that would make others wait, or overtake what was taken before.
  [[nodiscard]] Turn TakeTurn();
  /// Instead of the caller's mailbox, in which nothing waits: sends its call, or has the network
  /// thread do so as soon as the link has room. Returns how many calls were sent then, the last
  /// being this one, or 0 where it was not.
  std::uint64_t SendAtOnce(const Turn& turn, Question question);
  /// A caller's thread: the last of so many calls that were sent has been executed, so the others
  /// have, which were before it in one mailbox. What waits in the caller's may have room now.
  void OnExecuted(std::uint64_t calls, const Mailbox& callers);

  // Network thread, out of Send(): the next call.

  void Take(std::uint32_t handle, std::span<const std::byte> argument) {
    if (times_of_ == nullptr) return batch_.Add(handle, argument);
    batch_.AddTimed(handle, argument, times_of_->event_time());
  }
  void Take(Question question) { question_ = std::move(question); }

 private:
  /// Channel::TryRequest(), or TryAsk().
  using Manner = decltype(&Channel::TryRequest);

  [[nodiscard]] bool has_taken() const { return !batch_.empty() || question_; }
  [[nodiscard]] std::uint64_t Room() const;
  std::size_t SendTaken(std::size_t limit, Manner manner);
  void Collect(std::size_t limit);
  [[nodiscard]] Status Ask(Question& question, Manner manner);

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
  std::mutex raising_;  // executed_, which never falls: who learns of less may come later
  Published<std::uint64_t> executed_{0};

  bool has_waited_ = false;  // of the network thread: its last Send() found somebody sending

  mutable std::mutex sending_;  // of what follows
  std::uint64_t sent_ = 0;
  // Taken, but not sent.
  CallBatch batch_;
  std::optional<Question> question_;  // comes behind the batch
};

/// That of a member, where these names are of those that keep the latest only.
[[nodiscard]] Overflow OverflowOf(const std::vector<std::string>& latest_only,
                                  const std::string& member);

/// A command of another process that its component's thread executes, or a handler of its events:
/// what is called here is sent there. It takes encoded values alone; they are copied into buffers
/// that keep their capacity. One that keeps the latest only does so on its way, too.
class QueuedOfferProxy final : public Offer {
 public:
  QueuedOfferProxy(MemberDescription description, Outbox& outbox, std::uint32_t handle);

  [[nodiscard]] Mailbox::SlotShape shape() const override;
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

  /// How many calls were not accepted: no room, too large, or nobody to send them to.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.value(); }

 private:
  Outbox& outbox_;
  std::uint32_t handle_;
  mutable SharedCounter<> refused_;
};

}  // namespace tendon
