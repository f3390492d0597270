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

/// What kWait was answered with, whose result is put into `result`; or why there is no answer.
[[nodiscard]] Status TakeOutcome(Result<Bytes> answer, Bytes& result);

/// The calls of one command of another process whose callers wait here. A number leads from an
/// answer to the caller's completion record; it is nobody's once the caller has left, so that a
/// late answer finds nothing. Outlives the command where an answer is still to come. Thread-safe.
template <typename Pool = CompletionPool, typename Mutex = std::mutex>
class AwaitedCalls {
 public:
  /// `completions` lives as long as a caller waits.
  explicit AwaitedCalls(Pool& completions)
      : completions_(completions), of_record_(completions.size()), answers_(completions.size()) {}

  // The caller.

  /// Its number. It has taken the record.
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
  /// Before it returns, with what Await() said. Whether the call may have been executed: it was
  /// sent. If not, it will not be.
  template <typename Ending>
  bool Leave(std::uint64_t call, Ending ending) {
    const std::scoped_lock lock(mutex_);
    spare_ = awaited_.extract(call);
    assert(!spare_.empty());
    const Awaited& awaited = spare_.mapped();
    // The thread that Await() has left the record to will find nobody, unless it was there already.
    if (ending == Ending::kStarted && !awaited.has_ended) completions_[awaited.record].Free();
    return awaited.is_sent;
  }
  /// Of the call with this record, once that is done.
  [[nodiscard]] const Bytes& answer(std::size_t record) const { return answers_[record]; }

  // The network thread.

  /// The number of the posted call with this record, which is to be sent; nothing when its caller
  /// has left. The lock holds back the caller, who could free the record for another call between
  /// the two steps.
  [[nodiscard]] std::optional<std::uint64_t> Start(std::size_t record) {
    const std::scoped_lock lock(mutex_);
    if (!completions_[record].Start()) return std::nullopt;
    return of_record_[record];
  }
  /// Instead: the posted call will not be sent.
  void Drop(std::size_t record) noexcept {
    const std::scoped_lock lock(mutex_);
    if (!completions_[record].Start()) return;
    Finish(awaited_.at(of_record_[record]), Status::kNotConnected);
  }
  /// It is being sent: until when its caller waits. Nothing when that has left, or is about to, and
  /// it must not be.
  [[nodiscard]] std::optional<SteadyTime> Send(std::uint64_t call, SteadyTime now) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found == awaited_.end() || found->second.deadline <= now) return std::nullopt;
    found->second.is_sent = true;
    return found->second.deadline;
  }
  /// It was not, after all; it may be later.
  void NotSent(std::uint64_t call) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found != awaited_.end()) found->second.is_sent = false;
  }
  /// Nor will it be, for this reason.
  void Refuse(std::uint64_t call, Status why) {
    const std::scoped_lock lock(mutex_);
    const auto found = awaited_.find(call);
    if (found == awaited_.end()) return;
    found->second.is_sent = false;
    Finish(found->second, why);
  }

  /// Any thread: the answer to kWait, or why none will come.
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
    bool has_ended = false;  // the record was finished, which frees it if nobody waits
  };

  void Finish(Awaited& awaited, Status status) noexcept {
    awaited.has_ended = true;
    completions_[awaited.record].Finish(status);
  }

  Pool& completions_;
  Mutex mutex_;
  std::uint64_t last_ = 0;
  std::map<std::uint64_t, Awaited> awaited_;                    // from Enter() to Leave()
  typename std::map<std::uint64_t, Awaited>::node_type spare_;  // for the next one
  std::vector<std::uint64_t> of_record_;
  std::vector<Bytes> answers_;  // by record
};

}  // namespace tendon
