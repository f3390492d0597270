#include <tendon/proxy/outbox.h>

#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/executing_calls.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <thread>
#include <utility>

namespace tendon {
namespace {

/// A batch with this many bytes is full; it gets no further calls. An argument of this size is sent
/// without a batch.
constexpr std::size_t kFullBatch = std::size_t{32} << 10U;
static_assert(kMaxPayload + kFullBatch + CallBatch::kOverhead <= kMaxBodySize,
              "the largest argument fits after a batch that is almost full");

}  // namespace

Outbox::Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup,
               std::string interface, const OutboxLimits& limits)
    : channel_(std::move(channel)),
      type_(type),
      lane_(channel_->NewLane()),
      wakeup_(wakeup),
      refused_payloads_(std::move(interface)),
      waiting_bytes_(limits.waiting_bytes),
      inbox_(&wakeup),
      credit_(limits.credit) {
  inbox_.SetAccepting(true);
}

void Outbox::Close() {
  is_open_.Set(false);
  inbox_.SetAccepting(false);
}

void Outbox::RefusePayload(std::uint32_t handle, std::size_t size) noexcept {
  refused_payloads_.Note(handle, size);
  wakeup_.Notify();
}

void Outbox::SetExecuted(std::uint64_t calls) {
  const std::scoped_lock lock(raising_);
  if (calls > executed_.Get()) executed_.Set(calls);
}

void Outbox::OnExecuted(std::uint64_t calls, const Mailbox& mailbox) {
  SetExecuted(calls);
  if (mailbox.size() != 0) wakeup_.Notify();
}

bool Outbox::HasCallsUnderWay() const {
  const std::scoped_lock turn(sending_);
  return has_taken() || executed_.Get() < sent_;
}

bool Outbox::HasUnsent() const {
  // Without this lock, a call that moves from the inbox to the taken calls could be missed in both.
  const std::scoped_lock turn(sending_);
  return has_taken() || inbox_.size() > 0;
}

std::uint64_t Outbox::Room() const {
  const std::uint64_t under_way = sent_ - std::min(executed_.Get(), sent_);
  return credit_ - std::min(under_way, credit_);
}

std::size_t Outbox::Send(std::size_t limit) {
  refused_payloads_.Report();
  const Turn turn(sending_, std::try_to_lock);
  has_waited_ = !turn;
  if (!turn) return 0;
  if (executed_.Get() > sent_) {
    channel_->CutOff("acknowledged that " + std::to_string(executed_.Get()) +
                     " calls were executed, but only " + std::to_string(sent_) +
                     " were sent to it");
    return 0;
  }
  return SendTaken(std::min(limit, Room()), Delivery::kQueued);
}

Outbox::Turn Outbox::TakeTurn() {
  Turn turn(sending_, std::try_to_lock);
  if (turn && (!is_open() || has_taken() || Room() == 0)) turn.unlock();
  return turn;
}

std::uint64_t Outbox::SendNow([[maybe_unused]] const Turn& turn, BlockingCall call) {
  assert(turn.mutex() == &sending_ && turn.owns_lock() && !has_taken());
  blocking_call_ = std::move(call);
  SendTaken(1, Delivery::kDirect);
  if (!has_taken()) return sent_;
  wakeup_.Notify();
  return 0;
}

void Outbox::SendOrBatch(std::uint32_t handle, CallBuffer& call, const Mailbox& mailbox) {
  const bool is_large = call.argument().size() >= kFullBatch;
  const bool is_alone = is_large ? SendBatch() : batch_.empty() && mailbox.size() == 1;
  const auto frame = [&] {
    return times_of_ == nullptr ? call.Frame(handle)
                                : call.TimedFrame(handle, times_of_->event_time());
  };
  if (is_alone && SendFrame(frame(), 1)) return;
  AddToBatch(handle, call.argument());
}

/// Returns true if the batch is empty now, and false if the link has no room for it.
bool Outbox::SendBatch() {
  if (batch_.empty()) return true;
  if (!SendFrame(batch_.frame(), batch_.calls())) return false;
  batch_.Clear();
  return true;
}

/// Sends a frame with this number of calls. Returns false if the link has no room for it.
bool Outbox::SendFrame(std::span<std::byte> frame, std::size_t calls) {
  if (channel_->NotifyInPlace(type_, 0, frame, lane_) == Status(Status::kQueueFull)) return false;
  sent_ += calls;
  return true;
}

/// Sends up to `limit` calls: first the calls that were already taken from the inbox, then more
/// calls from the inbox. Counts each call when it is sent.
std::size_t Outbox::SendTaken(std::size_t limit, Delivery delivery) {
  const Status no_room = Status::kQueueFull;
  const std::uint64_t before = sent_;
  while (true) {
    const std::uint64_t sent = sent_ - before;
    if (!has_taken() && sent < limit) Collect(limit - sent);
    if (!has_taken() || !SendBatch()) return sent_ - before;
    if (!blocking_call_) continue;
    const Status asked = Request(*blocking_call_, delivery);
    if (asked == no_room) return sent_ - before;
    if (asked) ++sent_;
    blocking_call_.reset();
  }
}

void Outbox::SendRest(std::chrono::milliseconds timeout) {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(1);
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  while (is_held_up()) {
    (void)Send(0);
    if (!is_held_up() || SteadyClock().Now() >= deadline) return;
    std::this_thread::sleep_for(kUntilLinkHasRoom);
  }
}

/// Takes up to `limit` calls from the inbox, until the batch is full. Some of them are already sent
/// by SendOrBatch().
void Outbox::Collect(std::size_t limit) {
  const std::uint64_t before = sent_;
  while (!blocking_call_ && sent_ - before + batch_.calls() < limit &&
         batch_.body().size() < kFullBatch) {
    if (inbox_.ExecuteQueued(1) == 0) return;
  }
}

/// Sends a call as a request. The timeout at the other end begins now and is a little shorter than
/// the timeout of the caller. Therefore, the report of a timeout arrives before the caller times
/// out.
Status Outbox::Request(BlockingCall& call, Delivery delivery) {
  constexpr std::chrono::milliseconds kWayBack(20);
  const SteadyTime now = SteadyClock().Now();
  const auto deadline = call.callers->Send(call.number, now);
  if (!deadline) return Status::kTimeout;
  const std::chrono::nanoseconds left = *deadline - now;
  Bytes& body = call.argument;
  const std::size_t size = body.size();
  AppendTimeout(left - std::min<std::chrono::nanoseconds>(left / 4, kWayBack), body);
  const Status asked = channel_->TryRequest(
      message::kWait, call.handle, body, std::chrono::ceil<std::chrono::milliseconds>(left),
      [callers = call.callers, number = call.number](Result<Bytes> reply) {
        callers->End(number, std::move(reply));
      },
      lane_, delivery);
  body.resize(size);
  if (asked == Status(Status::kQueueFull)) {
    call.callers->NotSent(call.number);
  } else if (!asked) {
    call.callers->Refuse(call.number, asked);
  }
  return asked;
}

}  // namespace tendon
