#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The read commands that other processes mirror: tells them which are off, for their copies must
/// not answer then. Not thread-safe.
class MirroredCommands {
 public:
  /// One that is mirrored, and over which channel.
  struct Command {
    std::string component;
    const Flag* enabled = nullptr;  ///< lives until Remove(component)
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;  ///< of its copies
    Lane lane = kCommonLane;   ///< of its copies
  };

  void Add(Command command) { known_.push_back({.command = std::move(command)}); }
  void Remove(const Channel& channel, std::uint32_t handle);
  void Remove(const std::string& component);
  /// To be called now and then: who does not know yet is told.
  void Tell();

 private:
  struct Known {
    Command command;
    bool is_enabled = true;  // as was told last
  };

  std::vector<Known> known_;
};

}  // namespace tendon
