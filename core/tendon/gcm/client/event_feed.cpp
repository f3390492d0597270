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
  const auto listener = std::make_shared<EventListener>(std::move(wanted), std::move(sink));
  std::unique_lock lock(mutex_);
  const Id id = ++last_id_;
  if (is_stopped_) return id;
  listeners_[id] = listener;
  lock.unlock();
  Subscribe(listener);
  return id;
}

void EventFeed::End(Id id) {
  std::unique_lock lock(mutex_);
  const auto node = listeners_.extract(id);
  if (!node) return;
  std::erase_if(active_, [&](const auto& one) { return one.second == node.mapped(); });
  lock.unlock();
  node.mapped()->End();
}

void EventFeed::ReadPast(EventSubscription wanted, std::chrono::nanoseconds last,
                         std::shared_ptr<EventSink> sink, PastEventsReading::Done done) {
  const auto reading = std::make_shared<PastEventsReading>(std::move(wanted), last, std::move(sink),
                                                           std::move(done));
  if (!Keep(reading)) return;
  auto events = look_up_(reading->wanted());
  if (!events) return reading->Fail(events.error());
  reading->SetEvents(*std::move(events));
  links_->WithChannel(reading->wanted().provided.process,
                      [self = shared_from_this(), reading](const auto& channel) {
                        if (!channel) return reading->Fail(channel.error());
                        self->ClockOf(*channel)->WhenKnown(
                            [self, reading, channel = *channel](const Result<SharedClock>& clock) {
                              if (!clock) return reading->Fail(clock.error());
                              self->AskForPast(reading, channel, *clock);
                            });
                      });
}

bool EventFeed::Keep(const SharedReading& reading) {
  const std::scoped_lock lock(mutex_);
  if (is_stopped_) return false;
  std::erase_if(readings_, [](const auto& one) { return one.expired(); });
  readings_.push_back(reading);
  return true;
}

void EventFeed::Stop() {
  std::unique_lock lock(mutex_);
  is_stopped_ = true;
  const auto listeners = std::exchange(listeners_, {});
  const auto readings = std::exchange(readings_, {});
  active_.clear();
  lock.unlock();
  for (const auto& [id, listener] : listeners) listener->End();
  for (const auto& weak : readings) {
    if (const auto reading = weak.lock()) reading->End();
  }
}

void EventFeed::AskForPast(const SharedReading& reading, const std::shared_ptr<Channel>& channel,
                           const SharedClock& clock) {
  tendon::Ask<message::ReadEventsReply>(*timer_, channel, message::kReadEvents,
                                        reading->NextRequest(), timeout_,
                                        [self = shared_from_this(), reading, channel,
                                         clock](const Result<message::ReadEventsReply>& page) {
                                          if (!page) return reading->Fail(page.error());
                                          if (reading->Take(*page, *clock))
                                            self->AskForPast(reading, channel, clock);
                                        });
}

void EventFeed::Retry(const std::string& process) {
  const std::scoped_lock lock(mutex_);
  for (const auto& [id, listener] : listeners_) {
    if (listener->wanted().provided.process != process) continue;
    timer_->Post([weak = weak_from_this(), listener = listener] {
      if (const auto self = weak.lock()) self->Subscribe(listener);
    });
  }
}

/// Starts an attempt to subscribe, unless the subscription is active, in progress or ended.
void EventFeed::Subscribe(const SharedListener& listener) {
  std::unique_lock lock(mutex_);
  const std::uint32_t attempt = next_handle_;
  next_handle_ += 1 + static_cast<std::uint32_t>(listener->wanted().size());
  lock.unlock();
  if (!listener->Try(attempt)) return;
  links_->WithChannel(listener->wanted().provided.process,
                      [weak = weak_from_this(), listener, attempt](const auto& channel) {
                        const auto self = weak.lock();
                        if (!self) return;
                        if (!channel) return self->Fail(listener, attempt, channel.error());
                        const auto ask = [weak, listener, channel = *channel,
                                          attempt](const Result<SharedClock>& clock) {
                          const auto still = weak.lock();
                          if (!still) return;
                          if (!clock) return still->Fail(listener, attempt, clock.error());
                          still->Ask(listener, channel, *clock, attempt);
                        };
                        self->ClockOf(*channel)->WhenKnown(ask);  // gives every event a time
                      });
}

/// Returns the clock of the process at the other end. All subscriptions on a channel share this
/// clock.
EventFeed::SharedClock EventFeed::ClockOf(const std::shared_ptr<Channel>& channel) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(clocks_, [](const auto& one) { return one.second.expired(); });
  std::weak_ptr<SourceClock>& known = clocks_[channel.get()];
  SharedClock clock = known.lock();
  if (!clock) known = clock = std::make_shared<SourceClock>(timer_, channel, timeout_);
  return clock;
}

void EventFeed::Ask(const SharedListener& listener, const std::shared_ptr<Channel>& channel,
                    const SharedClock& clock, std::uint32_t attempt) {
  {
    const std::scoped_lock lock(mutex_);
    if (is_stopped_) return;
  }
  const EventSubscription& wanted = listener->wanted();
  const auto events = look_up_(wanted);
  if (!events) return Fail(listener, attempt, events.error());
  {
    const std::scoped_lock lock(mutex_);
    active_[{channel.get(), attempt}] = listener;  // events may follow the reply at once
  }
  tendon::Ask<message::OpenInterfaceReply>(
      *timer_, channel, message::kListen,
      message::OpenInterface{
          .required = InterfaceName(name_, wanted.commands.empty() ? "events" : "commands",
                                    wanted.provided.interface),
          .provided = wanted.provided,
          .description = {.name = wanted.provided.interface, .event_handlers = *events},
          .handle = attempt,
          .capacity = wanted.capacity},
      timeout_,
      [weak = weak_from_this(), listener, channel, clock, attempt,
       events = *events](const auto& reply) {
        const auto self = weak.lock();
        if (!self) return;
        if (!reply) {
          self->Take({channel.get(), attempt});
          self->Fail(listener, attempt, reply.error());
          // The process may still accept the subscription later. Closing the channel ends it then.
          if (reply.error().code == ErrorCode::kTimeout) channel->Close();
          return;
        }
        if (listener->OnSubscribed(attempt, {channel, reply->handle, clock}, events)) return;
        self->Take({channel.get(), attempt});
        (void)channel->Notify(message::kCloseInterface, reply->handle, Bytes());
      });
}

void EventFeed::Fail(const SharedListener& listener, std::uint32_t attempt, const Error& reason) {
  constexpr std::chrono::milliseconds kPause(500);
  if (!listener->Fail(attempt, reason)) return;
  timer_->PostAfter(kPause, [weak = weak_from_this(), listener] {
    if (const auto self = weak.lock()) self->Subscribe(listener);
  });
}

void EventFeed::OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body) {
  if (header.type == message::kTimedEvents) {
    ForEachTimedCall(body,
                     [&](std::uint32_t handle, std::span<const std::byte> value, SteadyTime there) {
                       const auto [listener, attempt] = Find(channel.get(), handle);
                       if (!listener || handle <= attempt) return;
                       listener->Raise(attempt, handle - attempt - 1, value, there);
                     });
  } else if (header.type == message::kEventsLost) {
    const auto [listener, attempt] = Find(channel.get(), header.handle);
    const auto lost = DecodeBody<message::EventsLost>(body);
    if (listener && lost && header.handle == attempt) listener->OnLost(attempt, *lost);
  } else if (header.type == message::kInterfaceClosed) {
    const auto listener = Take({channel.get(), header.handle});
    if (listener) Fail(listener, header.handle, ReadRefusal(body, channel->peer().name));
  }
}

void EventFeed::OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) {
  std::vector<std::pair<SharedListener, std::uint32_t>> interrupted;
  {
    const std::scoped_lock lock(mutex_);
    std::erase_if(active_, [&](const auto& one) {
      if (one.first.first != channel.get()) return false;
      interrupted.emplace_back(one.second, one.first.second);
      return true;
    });
  }
  for (const auto& [listener, attempt] : interrupted) {
    Fail(listener, attempt,
         {ErrorCode::kUnreachable,
          "process '" + listener->wanted().provided.process + "' was lost: " + reason.message});
  }
}

std::pair<EventFeed::SharedListener, std::uint32_t> EventFeed::Find(const Channel* channel,
                                                                    std::uint32_t handle) {
  const std::scoped_lock lock(mutex_);
  auto after = active_.upper_bound({channel, handle});
  if (after == active_.begin()) return {};
  const auto& [key, listener] = *--after;
  if (key.first != channel) return {};
  return {listener, key.second};
}

EventFeed::SharedListener EventFeed::Take(const Key& key) {
  const std::scoped_lock lock(mutex_);
  const auto node = active_.extract(key);
  return node ? node.mapped() : nullptr;
}

}  // namespace tendon::client
