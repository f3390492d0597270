#pragma once

#include <tendon/gcm/system_file.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <utility>

namespace tendon::gui {

/// The last states of a system, oldest first. Each change adds one state.
class Snapshots {
 public:
  static constexpr std::size_t kMax = 50;

  struct Snapshot {
    std::int64_t when = 0;  ///< ns since 1970
    SystemFile system{};
  };

  /// Adds a state, unless it is the same as the last one.
  void add(std::int64_t when, SystemFile system) {
    if (!all_.empty() && all_.back().system == system) return;
    all_.push_back({when, std::move(system)});
    if (all_.size() > kMax) all_.pop_front();
  }
  [[nodiscard]] const std::deque<Snapshot>& all() const { return all_; }

 private:
  std::deque<Snapshot> all_;
};

}  // namespace tendon::gui
