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

/// The outcome of a kWait: puts the result into `result`; or the status for its failure.
[[nodiscard]] Status TakeOutcome(Result<Bytes> answer, Bytes& result);

/// The calls of one remote command whose callers wait here. A number leads from a reply to the
/// caller's completion record. It becomes invalid when the caller gives up, so that a late reply
/// finds nothing. May outlive the command while a reply is still to come. Thread-safe.
template <typename Pool = CompletionPool, typename Mutex = std::mutex>
class OutstandingCalls {
 public:
  /// `completions` lives as long as a caller waits.
  explicit OutstandingCalls(Pool& completions)
      : completions_(completions), of_record_(completions.size()), answers_(completions.size()) {}

  // For the caller.

  /// Returns the number of the call. The caller owns the record.
  std::uint64_t Enter(std::size_t record, SteadyTime deadline) {
    const std::scoped_lock lock(mutex_);
    const Awaited awaited{.record = record, .deadline = deadline};
    if (spare_.empty()) {
      awaited_.emplace(last_ + 1, awaited);
    } else {
      spare_.key() = last_ + 1;
      spare_.mapped() = awaited;
      awaited_.insert(std::move(spare_));
    }
    of_record_[record] = ++last_;
    return last_;
  }
  /// Call it before returning, with the result of Await(). Returns whether the call was sent, and
  /// so may have been executed; if not, it never will be.
  template <typename Ending>
  bool Leave(std::uint64_t call, Ending ending) {
    const std::scoped_lock lock(mutex_);
    spare_ = awaited_.extract(call);
    assert(!spare_.empty());
    const Awaited& awaited = spare_.mapped();
    // The thread that would free the record no longer finds the call, unless it was there before.
    if (ending == Ending::kStarted && !awaited.has_ended) completions_[awaited.record].Free();
    return awaited.is_sent;
  }
  /// The answer of the call with this record, once it is done.
  [[nodiscard]] const Bytes& answer(std::size_t record) const { return answers_[record]; }

  // For the network thread.

  /// Returns the number of the posted call with this record, which is to be sent; nothing if its
  /// caller has left. The lock keeps the caller from reusing the record between the two steps.
  [[nodiscard]] std::optional<std::uint64_t> Start(std::size_t record) {
    const std::scoped_lock lock(mutex_);
    if (!completions_[record].Start()) return std::nullopt;
    return of_record_[record];
  }
  /// Instead of Start(): the posted call will not be sent.
  void Drop(std::size_t record) noexcept {
    const std::scoped_lock lock(mutex_);
    if (!completions_[record].Start()) return;
    Finish(awaited_.at(of_record_[record]), Status::kNotConnected);
  }
  /// Marks the call as sent. Returns until when its caller waits; nothing if that has left or its
  /// time is over: then the call must not be sent.
  [[nodiscard]] std::optional<SteadyTime> Send(std::uint64_t call, SteadyTime now) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found == awaited_.end() || found->second.deadline <= now) return std::nullopt;
    found->second.is_sent = true;
    return found->second.deadline;
  }
  /// Undoes Send(): the call may be sent later.
  void NotSent(std::uint64_t call) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found != awaited_.end()) found->second.is_sent = false;
  }
  /// The call will not be sent, for this reason.
  void Refuse(std::uint64_t call, Status why) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found == awaited_.end()) return;
    found->second.is_sent = false;
    Finish(found->second, why);
  }

  /// Any thread: the reply to kWait, or why none will come.
  void End(std::uint64_t call, Result<Bytes> answer) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found == awaited_.end()) return;
    Awaited& awaited = found->second;
    Finish(awaited, TakeOutcome(std::move(answer), answers_[awaited.record]));
  }

 private:
  struct Awaited {
    std::size_t record = 0;
    SteadyTime deadline{};
    bool is_sent = false;
    bool has_ended = false;  // the record was finished; that frees it if nobody waits
  };

  void Finish(Awaited& awaited, Status status) noexcept {
    awaited.has_ended = true;
    completions_[awaited.record].Finish(status);
  }

  Pool& completions_;
  Mutex mutex_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, Awaited> awaited_;                    // from Enter() to Leave()
  typename std::map<std::uint64_t, Awaited>::node_type spare_;  // reused for the next call
  std::vector<std::uint64_t> of_record_;
  std::vector<Bytes> answers_;  // by record
};

}  // namespace tendon
