#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <string>

namespace tendon {

/// The requests of one channel that wait for an answer. Every handler that was taken in is called
/// exactly once, without a lock held; what it throws is logged. Thread-safe.
class PendingRequests {
 public:
  using Handler = std::function<void(Result<Bytes>)>;

  /// Numbers a request; 0, and the handler is left alone, after FinishAll().
  std::uint64_t Add(std::chrono::milliseconds timeout, Handler& handler);

  /// It was never sent; its handler is not called.
  void Withdraw(std::uint64_t request);

  /// Calls the handler of `request`; false where it was called before.
  bool Finish(std::uint64_t request, Result<Bytes> outcome);

  /// Finish() for what came from the peer; counts what came too late.
  void OnAnswer(std::uint64_t request, Result<Bytes> answer);

  /// Finishes the requests whose time has come: `peer` gave no answer.
  void Expire(SteadyTime now, const std::string& peer);

  /// Finishes every request, now and for all time.
  void FinishAll(const Error& reason);

  [[nodiscard]] std::uint64_t late_answers() const;

 private:
  struct Pending {
    SteadyTime deadline;
    std::chrono::milliseconds timeout{};
    Handler handler;
  };

  mutable std::mutex mutex_;
  bool finished_ = false;
  std::uint64_t last_ = 0;
  std::uint64_t late_ = 0;
  std::map<std::uint64_t, Pending> pending_;
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
