#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/requests/answer.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// The requests of one channel that wait for an answer. Every handler that was taken in is called
/// exactly once, without a lock held; what it throws is logged. Thread-safe; allocates only where
/// more requests wait than ever before, beyond what handlers do.
class PendingRequests {
 public:
  using Handler = std::function<void(Result<Bytes>)>;

  /// Numbers a request; 0, and the handler is left alone, after FinishAll().
  std::uint64_t Add(std::chrono::milliseconds timeout, Handler& handler);

  /// It was never sent; its handler is not called.
  void Withdraw(std::uint64_t request);

  /// Calls the handler of `request`, or wakes who waits for it; false where that was done before.
  bool Finish(std::uint64_t request, Result<Answer> outcome);

  /// Finish() for what came from the peer; counts what came too late.
  void OnAnswer(std::uint64_t request, Result<Answer> answer);

  /// Whether an answer to it would not come too late; counts one that does.
  bool IsAwaited(std::uint64_t request);

  /// Finishes the requests whose time has come: `peer` gave no answer. Who waits sees to that.
  void Expire(SteadyTime now, const std::string& peer);

  /// Finishes every request, in their order, now and for all time.
  void FinishAll(const Error& reason);

  [[nodiscard]] std::uint64_t late_answers() const;

 private:
  friend class AwaitedAnswer;

  /// Of one request after the other. Stays where it is: of who waited for the one before, somebody
  /// may still be about to wake it.
  struct Place {
    std::uint64_t request = 0;
    SteadyTime deadline{};
    std::chrono::milliseconds timeout{};
    Handler handler;
    bool is_awaited = false;  // instead: somebody waits for the outcome
    std::optional<Result<Answer>> outcome;
    Flag has_ended;
    Wakeup<> wakeup;
  };

  // With the lock held.
  Place& Take();
  Place*& EntryOf(std::uint64_t request) { return by_number_[request & (by_number_.size() - 1)]; }
  [[nodiscard]] Place* Remove(std::uint64_t request);
  void Free(Place& place);

  bool FinishLocked(std::unique_lock<std::mutex>& lock, std::uint64_t request,
                    Result<Answer> outcome);
  Place* AddAwaited();
  std::optional<Result<Answer>> Leave(Place& place);

  mutable std::mutex mutex_;
  bool finished_ = false;
  std::uint64_t last_ = 0;
  std::uint64_t late_ = 0;
  std::deque<Place> places_;
  std::vector<Place*> free_;       // all would fit
  std::vector<Place*> by_number_;  // a power of two; no two requests have the same entry
};

/// "no answer from robot within 500 ms; outcome unknown"
[[nodiscard]] Error NoAnswer(const std::string& peer, std::chrono::milliseconds timeout);

/// Of what is being caught.
void LogFailure(const std::string& peer);

/// Calls code of others, which must not bring a thread of the middleware down: logs what it throws.
template <typename Function>
void CallGuarded(const std::string& peer, Function function) {
  try {
    function();
  } catch (...) {
    LogFailure(peer);
  }
}

}  // namespace tendon
