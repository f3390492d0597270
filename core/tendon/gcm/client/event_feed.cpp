#include <tendon/gcm/client/event_feed.h>
#include <tendon/process/ask.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/call_batch.h>

#include <utility>

namespace tendon::client {

EventFeed::EventFeed(std::shared_ptr<ProcessLinks> links, std::shared_ptr<Worker> timer,
                     LookUp look_up, std::string name, std::chrono::milliseconds timeout)
    : links_(std::move(links)),
      timer_(std::move(timer)),
      look_up_(std::move(look_up)),
      name_(std::move(name)),
      timeout_(timeout) {}

EventFeed::Id EventFeed::Listen(EventSubscription wanted, std::shared_ptr<EventSink> sink) {
  const auto listening = std::make_shared<Listening>(std::move(wanted), std::move(sink));
  std::unique_lock lock(mutex_);
  const Id id = ++last_id_;
  listenings_[id] = listening;
  lock.unlock();
  Pursue(listening);
  return id;
}

void EventFeed::End(Id id) {
  std::unique_lock lock(mutex_);
  const auto node = listenings_.extract(id);
  if (!node) return;
  std::erase_if(standing_, [&](const auto& one) { return one.second == node.mapped(); });
  lock.unlock();
  node.mapped()->End();
}

void EventFeed::Retry(const std::string& process) {
  const std::scoped_lock lock(mutex_);
  for (const auto& [id, listening] : listenings_) {
    if (listening->wanted().provided.process != process) continue;
    timer_->Post([weak = weak_from_this(), listening = listening] {
      if (const auto self = weak.lock()) self->Pursue(listening);
    });
  }
}

/// Starts an attempt for a subscription that is not active.
void EventFeed::Pursue(const SharedListening& listening) {
  std::unique_lock lock(mutex_);
  const std::uint32_t attempt = next_handle_;
  next_handle_ += 1 + static_cast<std::uint32_t>(listening->wanted().events.size());
  lock.unlock();
  if (!listening->Try(attempt)) return;
  links_->With(listening->wanted().provided.process,
               [weak = weak_from_this(), listening, attempt](const auto& channel) {
                 const auto self = weak.lock();
                 if (!self) return;
                 if (!channel) return self->Fail(listening, attempt, channel.error());
                 const auto ask = [weak, listening, channel = *channel,
                                   attempt](const Result<SharedClock>& clock) {
                   const auto still = weak.lock();
                   if (!still) return;
                   if (!clock) return still->Fail(listening, attempt, clock.error());
                   still->Ask(listening, channel, *clock, attempt);
                 };
                 self->ClockOf(*channel)->WhenKnown(ask);  // so that every event has a time
               });
}

/// All subscriptions on the channel share one clock.
EventFeed::SharedClock EventFeed::ClockOf(const std::shared_ptr<Channel>& channel) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(clocks_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<SourceClock>& known = clocks_[channel.get()];
  SharedClock clock = known.lock();
  if (!clock) known = clock = std::make_shared<SourceClock>(timer_, channel, timeout_);
  return clock;
}

void EventFeed::Ask(const SharedListening& listening, const std::shared_ptr<Channel>& channel,
                    const SharedClock& clock, std::uint32_t attempt) {
  const EventSubscription& wanted = listening->wanted();
  const auto events = look_up_(wanted);
  if (!events) return Fail(listening, attempt, events.error());
  {
    const std::scoped_lock lock(mutex_);
    standing_[{channel.get(), attempt}] = listening;  // events may follow the answer at once
  }
  tendon::Ask<message::OpenInterfaceReply>(
      *timer_, channel, message::kListen,
      message::OpenInterface{
          .required = InterfaceName(name_, "events", wanted.provided.interface),
          .provided = wanted.provided,
          .description = {.name = wanted.provided.interface, .event_handlers = *events},
          .handle = attempt,
          .capacity = wanted.capacity},
      timeout_,
      [weak = weak_from_this(), listening, channel, clock, attempt,
       events = *events](const auto& answer) {
        const auto self = weak.lock();
        if (!self) return;
        if (!answer) {
          self->Take({channel.get(), attempt});
          self->Fail(listening, attempt, answer.error());
          // If the process subscribes late, closing the channel ends that subscription.
          if (answer.error().code == ErrorCode::kTimeout) channel->Close();
          return;
        }
        if (listening->Stand(attempt, {channel, answer->handle, clock}, events)) return;
        self->Take({channel.get(), attempt});
        (void)channel->Notify(message::kCloseInterface, answer->handle, Bytes());
      });
}

void EventFeed::Fail(const SharedListening& listening, std::uint32_t attempt, const Error& reason) {
  constexpr std::chrono::milliseconds kPause(500);
  if (!listening->Fail(attempt, reason)) return;
  timer_->PostAfter(kPause, [weak = weak_from_this(), listening] {
    if (const auto self = weak.lock()) self->Pursue(listening);
  });
}

void EventFeed::OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body) {
  if (header.type == message::kTimedEvents) {
    ForEachTimedCall(body,
                     [&](std::uint32_t handle, std::span<const std::byte> value, SteadyTime there) {
                       const auto [listening, attempt] = Find(channel.get(), handle);
                       if (!listening || handle <= attempt) return;
                       listening->Raise(attempt, handle - attempt - 1, value, there);
                     });
  } else if (header.type == message::kEventsLost) {
    const auto [listening, attempt] = Find(channel.get(), header.handle);
    const auto lost = DecodeBody<message::EventsLost>(body);
    if (listening && lost && header.handle == attempt) listening->Lose(attempt, *lost);
  } else if (header.type == message::kInterfaceClosed) {
    const auto listening = Take({channel.get(), header.handle});
    if (listening) Fail(listening, header.handle, ReadRefusal(body, channel->peer().name));
  }
}

void EventFeed::OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) {
  std::vector<std::pair<SharedListening, std::uint32_t>> interrupted;
  {
    const std::scoped_lock lock(mutex_);
    std::erase_if(standing_, [&](const auto& one) {
      if (one.first.first != channel.get()) return false;
      interrupted.emplace_back(one.second, one.first.second);
      return true;
    });
  }
  for (const auto& [listening, attempt] : interrupted) {
    Fail(listening, attempt,
         {ErrorCode::kUnreachable,
          "process '" + listening->wanted().provided.process + "' was lost: " + reason.message});
  }
}

std::pair<EventFeed::SharedListening, std::uint32_t> EventFeed::Find(const Channel* channel,
                                                                     std::uint32_t handle) {
  const std::scoped_lock lock(mutex_);
  auto after = standing_.upper_bound({channel, handle});
  if (after == standing_.begin()) return {};
  const auto& [key, listening] = *--after;
  if (key.first != channel) return {};
  return {listening, key.second};
}

EventFeed::SharedListening EventFeed::Take(const Key& key) {
  const std::scoped_lock lock(mutex_);
  const auto node = standing_.extract(key);
  return node ? node.mapped() : nullptr;
}

}  // namespace tendon::client
