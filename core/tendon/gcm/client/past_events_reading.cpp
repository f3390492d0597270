#include <tendon/gcm/client/past_events_reading.h>

#include <tendon/gcm/client/source_clock.h>

#include <algorithm>
#include <utility>

namespace tendon::client {

PastEventsReading::PastEventsReading(EventSubscription wanted, std::chrono::nanoseconds last,
                                     std::shared_ptr<EventSink> sink, Done done)
    : wanted_(std::move(wanted)), sink_(std::move(sink)), done_(std::move(done)) {
  next_ = {.component = wanted_.provided.component,
           .interface = wanted_.provided.interface,
           .last = last};
}

bool PastEventsReading::Take(const message::ReadEventsReply& page, const SourceClock& clock) {
  if (const auto taken = TryTake(page, clock); !taken) {
    Fail(taken.error());
    return false;
  }
  const std::scoped_lock lock(mutex_);
  if (!done_) return false;
  if (next_.first < end_) return true;
  done_(read_);
  return false;
}

Result<void> PastEventsReading::TryTake(const message::ReadEventsReply& page,
                                        const SourceClock& clock) {
  const std::scoped_lock lock(mutex_);
  if (next_.epoch == 0) {
    next_.epoch = page.epoch;
    end_ = page.end;
    if (sink_) sink_->OnListening(events_);
  }
  const bool goes_on = page.next > next_.first || page.next >= end_;
  if (page.epoch == 0 || page.epoch != next_.epoch || !goes_on) {
    return Error{ErrorCode::kInvalid,
                 "process '" + wanted_.provided.process + "' sent invalid events of its history"};
  }
  for (const message::PastEvent& past : page.past) {
    if (past.event >= page.events.size() || !sink_) continue;
    const auto event = std::ranges::find(wanted_.events, page.events[past.event]);
    if (event == wanted_.events.end()) continue;
    const SteadyTime there{std::chrono::nanoseconds(past.time)};
    sink_->OnEvent(static_cast<std::size_t>(event - wanted_.events.begin()), past.value,
                   clock.ToLocal(ClockOffset::Sensible(there)));
    ++read_.events;
  }
  read_.lost += page.lost;
  next_.first = page.next;
  return {};
}

void PastEventsReading::Fail(const Error& reason) {
  const std::scoped_lock lock(mutex_);
  read_.failure = reason;
  if (done_) done_(read_);
}

void PastEventsReading::End() {
  const std::scoped_lock lock(mutex_);
  sink_ = nullptr;
  done_ = nullptr;
}

}  // namespace tendon::client
