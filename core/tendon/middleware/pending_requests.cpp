#include <tendon/middleware/pending_requests.h>

#include <tendon/base/log.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace tendon {

/// Returns a free slot with a new number. At most half of the entries are in use, so a few attempts
/// find a number whose entry is free.
PendingRequests::Slot& PendingRequests::Take() {
  constexpr std::size_t kFirst = 16;
  if (free_.empty()) {
    if (2 * (slots_.size() + 1) > by_number_.size()) {
      std::vector<Slot*> larger(std::max(kFirst, 2 * by_number_.size()));
      for (Slot* slot : by_number_) {
        if (slot != nullptr) larger[slot->request & (larger.size() - 1)] = slot;
      }
      free_.reserve(larger.size() / 2);
      by_number_ = std::move(larger);
    }
    free_.push_back(&slots_.emplace_back());
  }
  Slot& slot = *free_.back();
  free_.pop_back();
  do {
    ++last_;
  } while (EntryOf(last_) != nullptr);
  EntryOf(last_) = &slot;
  slot.request = last_;
  return slot;
}

/// Removes a request from the table and returns its slot; null if the request has ended.
PendingRequests::Slot* PendingRequests::Remove(std::uint64_t request) {
  if (by_number_.empty()) return nullptr;
  Slot*& entry = EntryOf(request);
  if (entry == nullptr || entry->request != request) return nullptr;
  return std::exchange(entry, nullptr);
}

void PendingRequests::Free(Slot& slot) {
  slot.request = 0;
  free_.push_back(&slot);
}

std::uint64_t PendingRequests::Add(std::chrono::milliseconds timeout, Handler& handler) {
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  const std::scoped_lock lock(mutex_);
  if (finished_) return 0;
  Slot& slot = Take();
  slot.deadline = deadline;
  slot.timeout = timeout;
  slot.is_awaited = false;
  slot.handler = std::move(handler);
  return slot.request;
}

/// Adds a request without a handler; returns null after FinishAll().
PendingRequests::Slot* PendingRequests::AddAwaited() {
  const std::scoped_lock lock(mutex_);
  if (finished_) return nullptr;
  Slot& slot = Take();
  slot.deadline = SteadyTime::max();
  slot.is_awaited = true;
  return &slot;
}

/// Called when a BlockingRequest stops waiting. Frees its slot and returns the outcome, if it is
/// known.
std::optional<Result<Reply>> PendingRequests::Leave(Slot& slot) {
  const std::scoped_lock lock(mutex_);
  (void)Remove(slot.request);
  auto outcome = std::exchange(slot.outcome, std::nullopt);
  slot.has_ended.Set(false);
  Free(slot);
  return outcome;
}

void PendingRequests::Withdraw(std::uint64_t request) {
  Handler unused;  // destroyed after the lock is released
  const std::scoped_lock lock(mutex_);
  Slot* const slot = Remove(request);
  if (slot == nullptr) return;
  unused = std::exchange(slot->handler, nullptr);
  Free(*slot);
}

bool PendingRequests::Finish(std::uint64_t request, Result<Reply> outcome) {
  std::unique_lock lock(mutex_);
  Slot* const slot = Remove(request);
  if (slot == nullptr) return false;
  if (!slot->is_awaited) {
    const Handler handler = std::exchange(slot->handler, nullptr);
    Free(*slot);
    lock.unlock();
    Result<Bytes> taken = Error{ErrorCode::kFailed, "there is not enough memory for the reply"};
    CallGuarded("request", [&] {
      taken = outcome ? Result<Bytes>((*std::move(outcome)).TakeBytes()) : outcome.error();
    });
    CallGuarded("request", [&] { handler(std::move(taken)); });
    return true;
  }
  slot->outcome = std::move(outcome);
  slot->has_ended.Set(true);
  lock.unlock();
  slot->wakeup.Notify();
  return true;
}

bool PendingRequests::IsAwaited(std::uint64_t request) {
  const std::scoped_lock lock(mutex_);
  const Slot* const slot = by_number_.empty() ? nullptr : EntryOf(request);
  return slot != nullptr && slot->request == request;
}

void PendingRequests::Expire(SteadyTime now, const std::string& peer) {
  std::vector<std::pair<std::uint64_t, std::chrono::milliseconds>> due;
  {
    const std::scoped_lock lock(mutex_);
    for (const Slot* slot : by_number_) {
      if (slot != nullptr && slot->deadline <= now) {
        due.emplace_back(slot->request, slot->timeout);
      }
    }
  }
  std::ranges::sort(due);
  for (const auto& [request, timeout] : due) Finish(request, NoReply(peer, timeout));
}

void PendingRequests::FinishAll(const Error& reason) {
  std::vector<std::uint64_t> all;
  {
    const std::scoped_lock lock(mutex_);
    finished_ = true;
    for (const Slot* slot : by_number_) {
      if (slot != nullptr) all.push_back(slot->request);
    }
  }
  std::ranges::sort(all);
  for (const std::uint64_t request : all) Finish(request, reason);
}

Error NoReply(const std::string& peer, std::chrono::milliseconds timeout) {
  return {ErrorCode::kTimeout, "no reply from " + peer + " within " +
                                   std::to_string(timeout.count()) + " ms; outcome unknown"};
}

void LogFailure(const std::string& peer) {
  try {
    throw;
  } catch (const std::exception& failure) {
    Log(LogLevel::kError, "channel", peer + ": " + failure.what());
  } catch (...) {
    Log(LogLevel::kError, "channel",
        peer + ": an exception was thrown that does not derive from std::exception");
  }
}

}  // namespace tendon
