#include <tendon/interface/event_base.h>

#include <utility>

namespace tendon {

EventBase::~EventBase() { current_.Exchange(nullptr); }

void EventBase::Subscribe(CommandBase& handler, SharedCounter<>* lost) {
  const std::scoped_lock lock(mutex_);
  auto next = list_ ? std::make_unique<List>(*list_) : std::make_unique<List>();
  next->push_back({&handler, Adapt(handler), lost});
  Replace(std::move(next));
}

void EventBase::Unsubscribe(CommandBase& handler) {
  const std::scoped_lock lock(mutex_);
  if (!list_) return;
  auto next = std::make_unique<List>(*list_);
  std::erase_if(*next, [&handler](const Subscriber& one) { return one.handler == &handler; });
  Replace(std::move(next));
}

void EventBase::SetSourceFaulted(bool faulted) {
  current_.Enter([faulted](const List* list) {
    if (list == nullptr) return;
    for (const Subscriber& subscriber : *list) subscriber.handler->SetSourceFaulted(faulted);
  });
}

void EventBase::Replace(std::unique_ptr<List> next) {
  current_.Exchange(next.get());  // waits until no thread uses the old list
  list_ = std::move(next);
  OnSubscribersChanged(!list_->empty());
}

}  // namespace tendon
