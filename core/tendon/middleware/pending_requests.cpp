#include <tendon/base/log.h>
#include <tendon/middleware/pending_requests.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace tendon {

/// Takes a place and gives it a new number. At most half of the entries are used, so a number with
/// a free entry is found soon.
PendingRequests::Place& PendingRequests::Take() {
  constexpr std::size_t kFirst = 16;
  if (free_.empty()) {
    if (2 * (places_.size() + 1) > by_number_.size()) {
      std::vector<Place*> larger(std::max(kFirst, 2 * by_number_.size()));
      for (Place* place : by_number_) {
        if (place != nullptr) larger[place->request & (larger.size() - 1)] = place;
      }
      free_.reserve(larger.size() / 2);
      by_number_ = std::move(larger);
    }
    free_.push_back(&places_.emplace_back());
  }
  Place& place = *free_.back();
  free_.pop_back();
  do {
    ++last_;
  } while (EntryOf(last_) != nullptr);
  EntryOf(last_) = &place;
  place.request = last_;
  return place;
}

/// Null if the request has ended.
PendingRequests::Place* PendingRequests::Remove(std::uint64_t request) {
  if (by_number_.empty()) return nullptr;
  Place*& entry = EntryOf(request);
  if (entry == nullptr || entry->request != request) return nullptr;
  return std::exchange(entry, nullptr);
}

void PendingRequests::Free(Place& place) {
  place.request = 0;
  free_.push_back(&place);
}

std::uint64_t PendingRequests::Add(std::chrono::milliseconds timeout, Handler& handler) {
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  const std::scoped_lock lock(mutex_);
  if (finished_) return 0;
  Place& place = Take();
  place.deadline = deadline;
  place.timeout = timeout;
  place.is_awaited = false;
  place.handler = std::move(handler);
  return place.request;
}

/// Null after FinishAll().
PendingRequests::Place* PendingRequests::AddAwaited() {
  const std::scoped_lock lock(mutex_);
  if (finished_) return nullptr;
  Place& place = Take();
  place.deadline = SteadyTime::max();
  place.is_awaited = true;
  return &place;
}

/// Ends the wait of a caller. Returns the outcome, if there is one.
std::optional<Result<Answer>> PendingRequests::Leave(Place& place) {
  const std::scoped_lock lock(mutex_);
  (void)Remove(place.request);
  auto outcome = std::exchange(place.outcome, std::nullopt);
  place.has_ended.Set(false);
  Free(place);
  return outcome;
}

void PendingRequests::Withdraw(std::uint64_t request) {
  Handler unused;  // destroyed without the lock
  const std::scoped_lock lock(mutex_);
  Place* const place = Remove(request);
  if (place == nullptr) return;
  unused = std::exchange(place->handler, nullptr);
  Free(*place);
}

bool PendingRequests::Finish(std::uint64_t request, Result<Answer> outcome) {
  std::unique_lock lock(mutex_);
  return FinishLocked(lock, request, std::move(outcome));
}

/// Releases the lock if it returns true.
bool PendingRequests::FinishLocked(std::unique_lock<std::mutex>& lock, std::uint64_t request,
                                   Result<Answer> outcome) {
  Place* const place = Remove(request);
  if (place == nullptr) return false;
  if (!place->is_awaited) {
    const Handler handler = std::exchange(place->handler, nullptr);
    Free(*place);
    lock.unlock();
    Result<Bytes> taken = Error{ErrorCode::kFailed, "there is not enough memory for the answer"};
    CallGuarded("request", [&] {
      taken = outcome ? Result<Bytes>((*std::move(outcome)).TakeBytes()) : outcome.error();
    });
    CallGuarded("request", [&] { handler(std::move(taken)); });
    return true;
  }
  place->outcome = std::move(outcome);
  place->has_ended.Set(true);
  lock.unlock();
  place->wakeup.Notify();
  return true;
}

void PendingRequests::OnAnswer(std::uint64_t request, Result<Answer> answer) {
  std::unique_lock lock(mutex_);
  if (!FinishLocked(lock, request, std::move(answer))) ++late_;
}

bool PendingRequests::IsAwaited(std::uint64_t request) {
  const std::scoped_lock lock(mutex_);
  const Place* const place = by_number_.empty() ? nullptr : EntryOf(request);
  const bool is_awaited = place != nullptr && place->request == request;
  if (!is_awaited) ++late_;
  return is_awaited;
}

void PendingRequests::Expire(SteadyTime now, const std::string& peer) {
  std::vector<std::pair<std::uint64_t, std::chrono::milliseconds>> due;
  {
    const std::scoped_lock lock(mutex_);
    for (const Place* place : by_number_) {
      if (place != nullptr && place->deadline <= now) {
        due.emplace_back(place->request, place->timeout);
      }
    }
  }
  std::ranges::sort(due);
  for (const auto& [request, timeout] : due) Finish(request, NoAnswer(peer, timeout));
}

void PendingRequests::FinishAll(const Error& reason) {
  std::vector<std::uint64_t> all;
  {
    const std::scoped_lock lock(mutex_);
    finished_ = true;
    for (const Place* place : by_number_) {
      if (place != nullptr) all.push_back(place->request);
    }
  }
  std::ranges::sort(all);
  for (const std::uint64_t request : all) Finish(request, reason);
}

std::uint64_t PendingRequests::late_answers() const {
  const std::scoped_lock lock(mutex_);
  return late_;
}

Error NoAnswer(const std::string& peer, std::chrono::milliseconds timeout) {
  return {ErrorCode::kTimeout, "no answer from " + peer + " within " +
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
