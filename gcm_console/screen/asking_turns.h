#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/client.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <mutex>
#include <vector>

namespace console {

/// Whose connection is asked about now: of each required interface once a second at most, and no
/// more at a time than so many without an answer, in all and of one process. That holds for
/// connections, too, that go and come back meanwhile. Thread-safe.
class AskingTurns {
 public:
  static constexpr std::chrono::seconds kBetween{1};
  static constexpr std::size_t kMostAtOnce = 64;
  static constexpr std::size_t kMostOfOne = 8;

  /// Those of `there` that are to be asked about now, who was asked longest ago first. End() is to
  /// follow for each.
  [[nodiscard]] std::vector<tendon::InterfaceName> Begin(
      const std::vector<tendon::InterfaceName>& there, tendon::SteadyTime now);
  /// The answer has come, or does not come.
  void End(const tendon::InterfaceName& required);

 private:
  struct Turn {
    tendon::SteadyTime asked = tendon::SteadyTime::min();
    bool is_under_way = false;
    bool is_there = false;
  };

  std::mutex mutex_;
  std::map<tendon::InterfaceName, Turn> turns_;
};

}  // namespace console
