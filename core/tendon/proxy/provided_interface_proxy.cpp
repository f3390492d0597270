#include <tendon/proxy/provided_interface_proxy.h>

#include <tendon/base/text.h>
#include <tendon/interface/connection.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/mirrored_read.h>
#include <tendon/proxy/queued_offer_proxy.h>
#include <tendon/proxy/read_offer_proxy.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

const MemberDescription* FindMember(const std::vector<MemberDescription>& members,
                                    const std::string& name) {
  const auto found = std::find_if(members.begin(), members.end(),
                                  [&name](const auto& member) { return member.name == name; });
  return found == members.end() ? nullptr : &*found;
}

}  // namespace

ProvidedInterfaceProxy::ProvidedInterfaceProxy(std::shared_ptr<NetworkThread> thread,
                                               const Remote& remote,
                                               const RequiredDescription& required,
                                               std::chrono::milliseconds read_deadline)
    : thread_(std::move(thread)),
      executor_(remote.executor),
      handle_(remote.opened.handle),
      mirrored_(remote.mirrored),
      outbox_(remote.channel, message::kCommands, thread_->wakeup(), ToString(remote.name),
              {.credit = remote.opened.credit}),
      loss_report_(remote.channel, handle_),
      interface_(remote.opened.description.name, &outbox_.inbox(), &remote_component_) {
  AddCommands(remote, required, read_deadline);
  AddEvents(remote.opened.description, required);
  interface_.Seal();
  outbox_.inbox().SetAccepting(remote.opened.accepting);
}

void ProvidedInterfaceProxy::AddCommands(const Remote& remote, const RequiredDescription& required,
                                         std::chrono::milliseconds read_deadline) {
  std::uint32_t handle = handle_;
  for (const MemberDescription& function : required.functions) {
    ++handle;
    const MemberDescription* command =
        FindMember(remote.opened.description.commands, function.name);
    if (command == nullptr) continue;
    const auto mirrored = mirrored_.find(function.name);
    if (CanBeAwaited(command->signature.kind)) {
      interface_.AddOffer(std::make_unique<QueuedOfferProxy>(*command, outbox_, handle))
          .SetOverflow(OverflowOf(remote.opened.latest_only, function.name));
    } else if (mirrored != mirrored_.end()) {
      interface_.AddOffer(std::make_unique<MirroredReadProxy>(*command, mirrored->second));
    } else {
      interface_.AddOffer(std::make_unique<ReadOfferProxy>(
          *command, ReadOfferProxy::Remote{.channel = remote.channel,
                                           .handle = handle,
                                           .deadline = read_deadline,
                                           .refused_payloads = &outbox_.refused_payloads()}));
    }
  }
}

void ProvidedInterfaceProxy::AddEvents(const ProvidedDescription& provided,
                                       const RequiredDescription& required) {
  for (const MemberDescription& handler : required.event_handlers) {
    events_.push_back(nullptr);
    const MemberDescription* event = FindMember(provided.events, handler.name);
    if (event == nullptr) continue;
    events_.back() = std::make_unique<EventProxy>();
    interface_.AddEvent(*events_.back(), *event);
    // Two threads raise events, because the middleware's thread may report faults of the source.
    if (executor_) events_.back()->SetRaisers(CallerThreads::kManyThreads, nullptr);
  }
}

void ProvidedInterfaceProxy::OnEvent(std::size_t handler, std::span<const std::byte> value) {
  if (handler >= events_.size() || !events_[handler]) return;
  if (!executor_) return Raise(handler, value);
  const bool is_posted = executor_->Post(
      [self = shared_from_this(), handler, copy = Bytes(value.begin(), value.end())] {
        self->CountLostEvents();
        self->Raise(handler, copy);
      },
      value.size());
  if (is_posted) return;
  events_[handler]->Miss();
  thread_->Notify();
}

void ProvidedInterfaceProxy::Raise(std::size_t handler, std::span<const std::byte> value) {
  EventProxy& event = *events_[handler];
  const std::uint64_t lost = event.lost();
  event.Raise(value);
  if (event.lost() != lost) thread_->Notify();
}

void ProvidedInterfaceProxy::OnEventsLost(const message::EventsLost& events) {
  for (std::size_t i = 0; i < std::min(events_.size(), events.lost.size()); ++i) {
    if (events_[i]) events_[i]->SetLostThere(events.lost[i]);
  }
  if (!executor_) return CountLostEvents();
  // If the queue of the executor is full, the calls in the queue will count these events.
  (void)executor_->Post([self = shared_from_this()] { self->CountLostEvents(); });
}

void ProvidedInterfaceProxy::DrainEvents(SteadyTime deadline) const {
  if (executor_) (void)executor_->Drain(deadline);
}

void ProvidedInterfaceProxy::CountLostEvents() {
  for (const auto& event : events_) {
    if (event) event->CountLost();
  }
}

bool ProvidedInterfaceProxy::OnCredit(const message::Credit& credit) {
  outbox_.SetExecuted(credit.executed);
  outbox_.inbox().SetAccepting(credit.accepting);
  thread_->Notify();
  const std::string fault = Printable(credit.fault);
  const bool is_faulted = !fault.empty();
  bool is_news = false;
  {
    const std::scoped_lock lock(mutex_);
    is_news = std::exchange(fault_, fault) != fault;
  }
  if (is_faulted != remote_component_.is_faulted()) {
    remote_component_.SetFaulted(is_faulted);
    // Posted to the executor, so that handlers get earlier events first.
    const bool is_posted = executor_ && executor_->Post([self = shared_from_this()] {
      self->interface_.SetSourceFaulted(self->remote_component_.is_faulted());
    });
    if (!is_posted) interface_.SetSourceFaulted(is_faulted);
  }
  return is_news;
}

void ProvidedInterfaceProxy::Sever() {
  outbox_.Close();
  for (const auto& [name, value] : mirrored_) value->End();
}

bool ProvidedInterfaceProxy::HasCallsUnderWay(const Connection& connection) {
  if (!outbox_.is_open() || !outbox_.inbox().accepting()) return false;
  return connection.waiting() > 0 || outbox_.HasCallsUnderWay();
}

std::string ProvidedInterfaceProxy::fault() const {
  const std::scoped_lock lock(mutex_);
  return fault_;
}

bool ProvidedInterfaceProxy::Work(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(1);
  const std::size_t sent = outbox_.Send();
  if (outbox_.is_held_up()) next = std::min(next, now + kUntilLinkHasRoom);
  for (std::size_t i = 0; i < events_.size(); ++i) {
    if (events_[i]) loss_report_.Set(i, events_[i]->lost_here());
  }
  loss_report_.Report(now, next);
  return sent > 0;
}

}  // namespace tendon
