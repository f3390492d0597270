#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/interface/execution/completion_pool.h>
#include <tendon/middleware/frame.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace tendon {

/// Reads the reply to a kWait request: sets `result` and returns the status.
[[nodiscard]] Status TakeOutcome(Result<Bytes> reply, Bytes& result);

/// The calls of one remote command whose callers wait in this process. Each call has a number, with
/// which its reply finds the completion record of the caller. The number becomes invalid when the
/// caller stops waiting, so a late reply is ignored. This object may outlive the command, because a
/// reply may still be expected. Thread-safe.
template <typename Pool = CompletionPool, typename Mutex = std::mutex>
class OutstandingCalls {
 public:
  /// `completions` must exist as long as a caller waits.
  explicit OutstandingCalls(Pool& completions)
      : completions_(completions), of_record_(completions.size()), replies_(completions.size()) {}

  // Functions for the caller.

  /// Adds a call and returns its number. The caller owns the completion record.
  std::uint64_t Enter(std::size_t record, SteadyTime deadline) {
    const std::scoped_lock lock(mutex_);
    const OutstandingCall outstanding{.record = record, .deadline = deadline};
    if (spare_.empty()) {
      calls_.emplace(last_ + 1, outstanding);
    } else {
      spare_.key() = last_ + 1;
      spare_.mapped() = outstanding;
      calls_.insert(std::move(spare_));
    }
    of_record_[record] = ++last_;
    return last_;
  }
  /// Removes the call. Every caller must call this function with the result of Await(). Returns
  /// true if the call was sent, so that it may have been executed. Returns false if the call was
  /// not sent and never will be.
  template <typename Ending>
  bool Leave(std::uint64_t call, Ending ending) {
    const std::scoped_lock lock(mutex_);
    spare_ = calls_.extract(call);
    assert(!spare_.empty());
    const OutstandingCall& outstanding = spare_.mapped();
    // The call was just removed from the map. If it has not ended, no other thread can free its
    // record.
    if (ending == Ending::kStarted && !outstanding.has_ended) {
      completions_[outstanding.record].Free();
    }
    return outstanding.is_sent;
  }
  /// The reply to the call with this record. Valid when the call is done.
  [[nodiscard]] const Bytes& reply(std::size_t record) const { return replies_[record]; }

  // Functions for the network thread.

  /// Starts the posted call with this record and returns its number. Returns nothing if its caller
  /// has stopped waiting. The lock prevents the caller from reusing the record during this
  /// function.
  [[nodiscard]] std::optional<std::uint64_t> Start(std::size_t record) {
    const std::scoped_lock lock(mutex_);
    if (!completions_[record].Start()) return std::nullopt;
    return of_record_[record];
  }
  /// Called instead of Start() if the posted call will never be sent. Ends the call with
  /// kNotConnected.
  void Drop(std::size_t record) noexcept {
    const std::scoped_lock lock(mutex_);
    if (!completions_[record].Start()) return;
    Finish(calls_.at(of_record_[record]), Status::kNotConnected);
  }
  /// Marks the call as sent and returns the deadline of its caller. Returns nothing if the caller
  /// has stopped waiting or the deadline has passed; then the call must not be sent.
  [[nodiscard]] std::optional<SteadyTime> Send(std::uint64_t call, SteadyTime now) {
    const std::scoped_lock lock(mutex_);
    const auto found = calls_.find(call);
    if (found == calls_.end() || found->second.deadline <= now) return std::nullopt;
    found->second.is_sent = true;
    return found->second.deadline;
  }
  /// Undoes Send(), because the call could not be sent now. It may be sent later.
  void NotSent(std::uint64_t call) {
    const std::scoped_lock lock(mutex_);
    const auto found = calls_.find(call);
    if (found != calls_.end()) found->second.is_sent = false;
  }
  /// Ends a call that will never be sent. Its caller gets the status `why`.
  void Refuse(std::uint64_t call, Status why) {
    const std::scoped_lock lock(mutex_);
    const auto found = calls_.find(call);
    if (found == calls_.end()) return;
    found->second.is_sent = false;
    Finish(found->second, why);
  }

  /// Ends a call with the reply to its kWait request, or with the reason why there is no reply. Any
  /// thread.
  void End(std::uint64_t call, Result<Bytes> reply) {
    const std::scoped_lock lock(mutex_);
    const auto found = calls_.find(call);
    if (found == calls_.end()) return;
    OutstandingCall& outstanding = found->second;
    Finish(outstanding, TakeOutcome(std::move(reply), replies_[outstanding.record]));
  }

 private:
  struct OutstandingCall {
    std::size_t record = 0;
    SteadyTime deadline{};
    bool is_sent = false;
    bool has_ended = false;  // true after Finish()
  };

  void Finish(OutstandingCall& outstanding, Status status) noexcept {
    outstanding.has_ended = true;
    completions_[outstanding.record].Finish(status);
  }

  Pool& completions_;
  Mutex mutex_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, OutstandingCall> calls_;  // calls between Enter() and Leave()
  // A map node that is reused for the next call.
  typename std::map<std::uint64_t, OutstandingCall>::node_type spare_;
  std::vector<std::uint64_t> of_record_;
  std::vector<Bytes> replies_;  // indexed by record
};

}  // namespace tendon
