#include <tendon/interface/inbox.h>

#include <tendon/interface/command.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace tendon {

Inbox::Inbox(Wakeup<>* wakeup) { server_.wakeup = wakeup; }

Inbox::~Inbox() { current_.Exchange(nullptr); }

Mailbox& Inbox::Open(std::size_t capacity, Mailbox::SlotShape argument, CallerThreads callers,
                     SteadyTime* event_time) {
  const std::scoped_lock lock(mutex_);
  auto next = Copy();
  const std::size_t place = FreePlace(*next);
  auto mailbox = std::make_unique<Mailbox>(capacity, argument, callers, server_,
                                           next->FlagOf(place), event_time, ++opened_);
  Mailbox& opened = *mailbox;
  opened.SetObserved(observers_ > 0);
  next->mailboxes[place] = &opened;
  mailboxes_.push_back(std::move(mailbox));
  list_.swap(next);
  const SteadyTime deadline = StdAtomics::Now() + std::chrono::milliseconds(1);
  if (!current_.TryExchange(list_.get(), deadline)) {
    retired_.push_back({std::move(next), nullptr, {}});  // a thread still uses the old list
  }
  return opened;
}

void Inbox::SetAccepting(bool accepting) {
  server_.accepting.Set(accepting);
  if (accepting) return;
  const std::scoped_lock lock(mutex_);
  for (const auto& mailbox : mailboxes_) mailbox->completions().Interrupt();
}

void Inbox::AddObserver() {
  const std::scoped_lock lock(mutex_);
  CountObservers(observers_ + 1);
}

void Inbox::RemoveObserver() {
  const std::scoped_lock lock(mutex_);
  CountObservers(observers_ - 1);
}

/// Called with the lock held.
void Inbox::CountObservers(std::size_t observers) {
  observers_ = observers;
  for (const auto& mailbox : mailboxes_) mailbox->SetObserved(observers > 0);
}

std::size_t Inbox::Remove(Mailbox& mailbox, std::vector<std::unique_ptr<CommandBase>> commands,
                          SteadyTime deadline) {
  mailbox.Close();
  const std::scoped_lock lock(mutex_);
  auto next = Copy();
  const auto listed = std::find(next->mailboxes.begin(), next->mailboxes.end(), &mailbox);
  assert(listed != next->mailboxes.end());
  *listed = nullptr;
  const auto found =
      std::find_if(mailboxes_.begin(), mailboxes_.end(),
                   [&mailbox](const auto& candidate) { return candidate.get() == &mailbox; });
  assert(found != mailboxes_.end());
  std::size_t dropped = 0;
  list_.swap(next);
  const bool is_free = current_.TryExchange(list_.get(), deadline);
  if (is_free) {
    while (mailbox.DropOne()) ++dropped;
    retired_.clear();
  } else {
    mailbox.Abandon();
    dropped = mailbox.size();
    retired_.push_back({std::move(next), std::move(*found), std::move(commands)});
  }
  mailboxes_.erase(found);
  return dropped;
}

template <typename Action>
void Inbox::List::ForEachReady(ReadyFlag<>::IfEmpty if_empty, Action action) const {
  Mailbox* const* mailbox = mailboxes.data();
  Mailbox* const* const end = mailbox + mailboxes.size();
  for (FlagRow* const row : rows) {
    for (auto flag = row->flags.begin(); flag != row->flags.end() && mailbox != end;
         ++flag, ++mailbox) {
      if (*mailbox == nullptr) continue;  // removed from this list
      std::size_t waiting = 0;
      const auto has_calls = [&] {
        waiting = (*mailbox)->size();
        return waiting > 0;
      };
      if (flag->IsReady(has_calls, if_empty) && !action(**mailbox, waiting)) return;
    }
  }
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
  const List* const list = call.get();
  if (list == nullptr) return 0;
  // One pass in `kPasses` lowers the flags of empty mailboxes. After that, an idle mailbox costs
  // one byte load.
  constexpr unsigned kPasses = 64;
  const bool lowers = ++passes_ % kPasses == 0;
  const auto if_empty = lowers ? ReadyFlag<>::IfEmpty::kLower : ReadyFlag<>::IfEmpty::kLeaveUp;
  list->ForEachReady(if_empty, [&](Mailbox& mailbox, std::size_t waiting) {
    if (mailbox.is_held()) return true;
    waiting = std::min(waiting, limit - executed);
    for (std::size_t i = 0; i < waiting && !mailbox.is_abandoned() && mailbox.ExecuteOne(); ++i) {
      ++executed;
    }
    return true;
  });
  return executed;
}

bool Inbox::has_queued() noexcept {
  const GuardedPointer<List>::Call call(current_);
  const List* const list = call.get();
  bool is_queued = false;
  if (list == nullptr) return false;
  list->ForEachReady(ReadyFlag<>::IfEmpty::kLeaveUp, [&](const Mailbox& mailbox, std::size_t) {
    is_queued = !mailbox.is_held();
    return !is_queued;
  });
  return is_queued;
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

Inbox::Fill Inbox::fill() const {
  const std::scoped_lock lock(mutex_);
  Fill fullest;
  for (const auto& mailbox : mailboxes_) {
    const Fill fill{mailbox->size(), mailbox->capacity()};
    const bool is_fuller = fill.waiting * fullest.capacity > fullest.waiting * fill.capacity;
    if (fullest.capacity == 0 || is_fuller) fullest = fill;
  }
  return fullest;
}

std::unique_ptr<Inbox::List> Inbox::Copy() const {
  return list_ ? std::make_unique<List>(*list_) : std::make_unique<List>();
}

std::size_t Inbox::FreePlace(List& list) {
  const auto is_free = [&](std::size_t place) {
    // A thread that uses an old list may still lower the flag at this place.
    const auto is_of_old = [place](const RetiredMailbox& one) {
      const Mailboxes& old = one.list->mailboxes;
      return one.mailbox != nullptr && place < old.size() && old[place] == one.mailbox.get();
    };
    return list.mailboxes[place] == nullptr &&
           std::none_of(retired_.begin(), retired_.end(), is_of_old);
  };
  std::size_t place = 0;
  while (place < list.mailboxes.size() && !is_free(place)) ++place;
  if (place == list.mailboxes.size()) list.mailboxes.push_back(nullptr);
  if (place / kRow == list.rows.size()) {
    rows_.push_back(std::make_unique<FlagRow>());
    list.rows.push_back(rows_.back().get());
  }
  return place;
}

}  // namespace tendon
