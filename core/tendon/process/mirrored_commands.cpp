#include <tendon/process/mirrored_commands.h>

#include <tendon/proxy/connection_messages.h>

#include <algorithm>

namespace tendon {

void MirroredCommands::Remove(const Channel& channel, std::uint32_t handle) {
  std::erase_if(known_, [&](const KnownCommand& one) {
    return one.command.channel.get() == &channel && one.command.handle == handle;
  });
}

void MirroredCommands::Remove(const std::string& component) {
  std::erase_if(known_,
                [&](const KnownCommand& one) { return one.command.component == component; });
}

/// Sends the changes; if the link is full, the next call tries again.
void MirroredCommands::Report() {
  std::erase_if(known_, [](const KnownCommand& one) { return !one.command.channel->is_open(); });
  for (KnownCommand& one : known_) {
    const MirroredCommand& command = one.command;
    const bool is_enabled = command.enabled->Get();
    if (is_enabled == one.is_enabled) continue;
    const Status sent =
        command.channel->Notify(message::kMirrorTurned, command.handle, is_enabled, command.lane);
    if (sent) one.is_enabled = is_enabled;
  }
}

}  // namespace tendon
