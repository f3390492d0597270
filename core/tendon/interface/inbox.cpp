#include <tendon/interface/inbox.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace tendon {

Inbox::Inbox(Wakeup<>* wakeup) { server_.wakeup = wakeup; }

Inbox::~Inbox() { current_.Exchange(nullptr); }

Mailbox& Inbox::Open(std::size_t capacity, Mailbox::SlotShape argument, Callers callers) {
  auto mailbox = std::make_unique<Mailbox>(capacity, argument, callers, server_);
  Mailbox& opened = *mailbox;
  const std::scoped_lock lock(mutex_);
  auto next = list_ ? std::make_unique<List>(*list_) : std::make_unique<List>();
  next->push_back(&opened);
  mailboxes_.push_back(std::move(mailbox));
  Replace(std::move(next));
  return opened;
}

void Inbox::SetAccepting(bool accepting) {
  server_.accepting.Set(accepting);
  if (accepting) return;
  const std::scoped_lock lock(mutex_);
  for (const auto& mailbox : mailboxes_) mailbox->completions().Interrupt();
}

std::size_t Inbox::Remove(Mailbox& mailbox) {
  mailbox.Close();
  const std::scoped_lock lock(mutex_);
  auto next = std::make_unique<List>(*list_);
  std::erase(*next, &mailbox);
  Replace(std::move(next));
  const auto found =
      std::find_if(mailboxes_.begin(), mailboxes_.end(),
                   [&mailbox](const auto& candidate) { return candidate.get() == &mailbox; });
  assert(found != mailboxes_.end());
  std::size_t dropped = 0;
  while (mailbox.DropOne()) ++dropped;
  mailboxes_.erase(found);
  return dropped;
}

std::size_t Inbox::ExecuteQueued(std::size_t limit) {
  if (executing_) return 0;
  executing_ = true;
  struct Done {
    bool& executing;
    ~Done() { executing = false; }
  } const done{executing_};

  std::size_t executed = 0;
  const GuardedPointer<List>::Call call(current_);
  if (call.get() == nullptr) return 0;
  for (Mailbox* mailbox : *call.get()) {
    const std::size_t waiting = std::min(mailbox->size(), limit - executed);
    for (std::size_t i = 0; i < waiting && mailbox->ExecuteOne(); ++i) ++executed;
  }
  return executed;
}

bool Inbox::has_queued() noexcept {
  const GuardedPointer<List>::Call call(current_);
  return call.get() != nullptr &&
         std::any_of(call.get()->begin(), call.get()->end(),
                     [](const Mailbox* mailbox) { return mailbox->size() > 0; });
}

std::size_t Inbox::DiscardQueued() {
  const std::scoped_lock lock(mutex_);
  std::size_t discarded = 0;
  for (const auto& mailbox : mailboxes_) {
    while (mailbox->DropOne()) ++discarded;
  }
  return discarded;
}

std::size_t Inbox::size() const {
  const std::scoped_lock lock(mutex_);
  std::size_t sum = 0;
  for (const auto& mailbox : mailboxes_) sum += mailbox->size();
  return sum;
}

void Inbox::Replace(std::unique_ptr<List> next) {
  current_.Exchange(next.get());  // waits until nobody walks the old list
  list_ = std::move(next);
}

}  // namespace tendon
