#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/client.h>
#include <tendon/recording/recording_writer.h>

#include <string>
#include <vector>

namespace tendon::recording {

/// The tables, events and commands of a running system that a recorder records.
struct RecordingSelection {
  std::vector<TableSubscription> tables{};
  std::vector<EventSubscription> events{};
  std::vector<EventSubscription> commands{};

  [[nodiscard]] bool is_empty() const {
    return tables.empty() && events.empty() && commands.empty();
  }
};

/// Returns the tables, events and commands of the catalogue that match `patterns`. A pattern is a
/// path or a glob of a process, a component, an interface, a column, an event or a command. It
/// selects everything in the matching objects, except read commands. Cost: each column, event and
/// command is compared with each pattern.
[[nodiscard]] RecordingSelection Select(const Catalogue& catalogue,
                                        const std::vector<std::string>& patterns);

/// Describes a recording of these patterns: the user, the recorded paths, and the system as a
/// system file.
[[nodiscard]] Heading HeadingFor(const Catalogue& catalogue,
                                 const std::vector<std::string>& patterns);

}  // namespace tendon::recording
