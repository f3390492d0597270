#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The read commands of this process that other processes mirror: these processes keep a copy of
/// the newest reply. Reports to them which commands are disabled, because the copy of a disabled
/// command must not be read. Not thread-safe.
class MirroredCommands {
 public:
  /// A mirrored command and its channel.
  struct MirroredCommand {
    std::string component;
    const Flag* enabled = nullptr;  ///< valid until Remove(component)
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;  ///< handle of the frames with copies
    Lane lane = kCommonLane;   ///< lane of the frames with copies
  };

  void Add(MirroredCommand command) { known_.push_back({.command = std::move(command)}); }
  void Remove(const Channel& channel, std::uint32_t handle);
  void Remove(const std::string& component);
  /// Reports the commands that were enabled or disabled since the last call. Call it regularly.
  void Report();

 private:
  struct KnownCommand {
    MirroredCommand command;
    bool is_enabled = true;  // the last reported state
  };

  std::vector<KnownCommand> known_;
};

}  // namespace tendon
