#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/command.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/requests/responder.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

/// Calls from elsewhere that a component here is to execute, and whose ends somebody there waits
/// for. Nobody waits for them here: the network thread looks, whenever it is told that one has
/// ended. Not thread-safe.
class BegunCalls {
 public:
  /// A call that `command` has begun, which lives until it was answered.
  struct Begun {
    CommandBase* command = nullptr;
    std::size_t call = 0;
    SteadyTime since{};
    SteadyTime deadline{};
    std::size_t function = 0;  ///< as the owner counts
    Responder responder;
  };
  /// Who answers them.
  class Owner {
   public:
    virtual ~Owner() = default;
    /// Has ended, or will not; with the result where the status is good, which is the owner's now.
    virtual void OnEnd(Begun& begun, Status status, Bytes& result) = 0;
  };

  /// The network thread may not be told of a call that was begun just when its server stopped: so
  /// often it looks.
  static constexpr std::chrono::milliseconds kNextLook{100};

  explicit BegunCalls(Owner& owner) : owner_(owner) {}
  void Add(Begun begun) {
    newest_ = begun.since;
    begun_.push_back(std::move(begun));
  }
  /// When the network thread must look at a call that is added now, unless it is told before.
  [[nodiscard]] static SteadyTime FirstLook(const Begun& begun) {
    return std::min(begun.deadline, begun.since + 2 * kNextLook);
  }
  /// Answers those that have ended or whose time is over, in the order in which they were begun,
  /// many in a message; brings `next` forward to when the next is.
  void Answer(SteadyTime now, SteadyTime& next);
  /// Answers them all, for their connection ends.
  void GiveUp();

 private:
  void End(Begun& begun, Status if_not_started);

  Owner& owner_;
  std::vector<Begun> begun_;
  SteadyTime newest_{};
  Bytes result_;
};

/// The body of kWait.
void AppendTimeout(std::chrono::nanoseconds timeout, Bytes& question);
/// Takes it off again; nothing where there is none.
std::optional<std::chrono::nanoseconds> TakeTimeout(std::span<const std::byte>& question);

}  // namespace tendon
