#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/command.h>
#include <tendon/middleware/frame.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

/// Calls from elsewhere that a component here is to execute, and whose ends somebody there waits
/// for. Nobody waits for them here: the network thread looks. Not thread-safe.
class BegunCalls {
 public:
  /// With the result where the status is good.
  using Done = std::function<void(Status status, const Bytes& result)>;

  /// `command` has begun `call`, and lives until that was answered.
  void Add(CommandBase& command, std::size_t call, SteadyTime deadline, Done done);
  /// Answers those that have ended or whose time is over; brings `next` forward to when the next
  /// is.
  void Answer(SteadyTime now, SteadyTime& next);
  /// Answers them all, for their connection ends.
  void GiveUp();

 private:
  struct Begun {
    CommandBase* command = nullptr;
    std::size_t call = 0;
    SteadyTime deadline{};
    Done done;
  };

  void End(const Begun& begun, Status if_not_started);

  std::vector<Begun> begun_;
  Bytes result_;
};

/// The body of kWait.
void AppendTimeout(std::chrono::nanoseconds timeout, Bytes& question);
/// Takes it off again; nothing where there is none.
std::optional<std::chrono::nanoseconds> TakeTimeout(std::span<const std::byte>& question);

}  // namespace tendon
