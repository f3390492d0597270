#pragma once

#include <tendon/base/clock.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace tendon {

/// Ends the effect of a command that the client must repeat, for example a movement: runs `end` if
/// the command was executed, but not again within the time limit.
///
/// Thread safety: only the thread that executes the calls of the component uses it.
class Expiry {
 public:
  /// Runs `end` if the command was not executed during the time `after`.
  Expiry(std::string command, std::chrono::nanoseconds after, std::function<void()> end)
      : command_(std::move(command)),
        message_(
            "command '" + command_ + "' was not renewed within " +
            std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(after).count()) +
            " ms: the action that it started was ended"),
        after_(after),
        end_(std::move(end)) {}

  [[nodiscard]] const std::string& command() const { return command_; }
  /// The text for the log.
  [[nodiscard]] const std::string& message() const { return message_; }

  /// Restarts the time limit. Called when the command is executed for the connection with this
  /// number.
  void Renew(std::uint64_t connection) noexcept {
    due_ = SteadyClock().Now() + after_;
    connection_ = connection;
  }
  /// Stops the time limit. Called when there is no effect that must end.
  void Disarm() noexcept { due_ = SteadyTime::max(); }
  /// Returns the time when `end` is due; the largest time if there is no effect to end.
  [[nodiscard]] SteadyTime due() const noexcept { return due_; }
  /// True if the last call that requested the present effect came through this connection.
  [[nodiscard]] bool IsOf(std::uint64_t connection) const noexcept {
    return due_ != SteadyTime::max() && connection_ == connection;
  }
  /// Stops the time limit and runs `end`. Throws the exceptions of the author's code.
  void End() {
    Disarm();
    end_();
  }

 private:
  std::string command_;
  std::string message_;
  std::chrono::nanoseconds after_;
  std::function<void()> end_;
  SteadyTime due_ = SteadyTime::max();
  std::uint64_t connection_ = 0;
};

}  // namespace tendon
