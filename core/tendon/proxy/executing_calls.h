#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/command.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/responder.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

/// Calls from other processes that a component of this process executes, and whose callers wait for
/// the reply. No thread of this process waits for these calls. The network thread checks them when
/// it is notified that a call has ended. Not thread-safe.
class ExecutingCalls {
 public:
  /// A call that `command` has begun. `command` must exist until the call is answered.
  struct ExecutingCall {
    CommandBase* command = nullptr;
    std::size_t call = 0;
    SteadyTime since{};
    SteadyTime deadline{};
    std::size_t function = 0;  ///< index of the function, for the owner
    Responder responder;
  };
  /// The owner sends the replies.
  class Owner {
   public:
    virtual ~Owner() = default;
    /// Called when the call has ended or will not be executed. The owner may move from `result` if
    /// the status is good.
    virtual void OnEnd(ExecutingCall& executing, Status status, Bytes& result) = 0;
  };

  /// The time between two checks without a notification. These checks are necessary, because a call
  /// may end without a notification if its server stops just when the call begins.
  static constexpr std::chrono::milliseconds kNextLook{100};

  explicit ExecutingCalls(Owner& owner) : owner_(owner) {}
  void Add(ExecutingCall executing) {
    newest_ = executing.since;
    executing_.push_back(std::move(executing));
  }
  /// Returns the time when the network thread must check a new call for the first time, if it gets
  /// no notification before.
  [[nodiscard]] static SteadyTime FirstLook(const ExecutingCall& executing) {
    return std::min(executing.deadline, executing.since + 2 * kNextLook);
  }
  /// Replies to the calls that have ended or timed out, in the order in which they were begun.
  /// Sends many replies in one message. If the next check is due before `next`, sets `next` to the
  /// time of the check.
  void SendReplies(SteadyTime now, SteadyTime& next);
  /// Replies to all calls, because their connection is closed.
  void GiveUp();

 private:
  void End(ExecutingCall& executing, Status if_not_started);

  Owner& owner_;
  std::vector<ExecutingCall> executing_;
  SteadyTime newest_{};
  Bytes result_;
};

/// Appends the timeout to the body of a kWait request.
void AppendTimeout(std::chrono::nanoseconds timeout, Bytes& argument);
/// Removes the timeout and returns it; empty if it is missing.
std::optional<std::chrono::nanoseconds> TakeTimeout(std::span<const std::byte>& argument);

}  // namespace tendon
