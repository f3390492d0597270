#include <tendon/recording/recording_selection.h>

#include <tendon/base/os/process.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/interface/observed_call.h>

#include <algorithm>
#include <utility>

namespace tendon::recording {
namespace {

bool IsWithinAny(const std::vector<std::string>& patterns, const std::string& path) {
  return std::ranges::any_of(
      patterns, [&](const std::string& pattern) { return IsWithinGlob(pattern, path); });
}

}  // namespace

RecordingSelection Select(const Catalogue& catalogue, const std::vector<std::string>& patterns) {
  RecordingSelection selection;
  for (const auto& [process, entry] : catalogue.processes()) {
    for (const auto& [component, description] : entry.components) {
      for (const TableDescription& table : description.tables) {
        TableSubscription one{process, component, table.name, {}};
        const std::string path = ToString(InterfaceName(process, component, table.name)) + ".";
        for (const auto& column : table.columns) {
          if (IsWithinAny(patterns, path + column.name)) one.columns.push_back(column.name);
        }
        if (!one.columns.empty()) selection.tables.push_back(std::move(one));
      }
      for (const ProvidedDescription& provided : description.provided) {
        EventSubscription one{.provided = {process, component, provided.name}, .events = {}};
        const std::string path = ToString(one.provided) + ".";
        for (const MemberDescription& event : provided.events) {
          if (IsWithinAny(patterns, path + event.name)) one.events.push_back(event.name);
        }
        if (!one.events.empty()) selection.events.push_back(std::move(one));
        EventSubscription calls{.provided = {process, component, provided.name}, .events = {}};
        for (const MemberDescription& command : provided.commands) {
          const bool is_wanted =
              CanBeObserved(command.signature) && IsWithinAny(patterns, path + command.name);
          if (is_wanted) calls.commands.push_back(command.name);
        }
        if (!calls.commands.empty()) selection.commands.push_back(std::move(calls));
      }
    }
  }
  return selection;
}

Heading HeadingFor(const Catalogue& catalogue, const std::vector<std::string>& patterns) {
  Heading heading{{{"paths", Joined(patterns, " ")}, {"recorded_by", os::UserAtHost()}}, ""};
  auto text = SystemFileText(SystemOf(catalogue, "recorded").file);
  if (text) heading.system = *std::move(text);
  return heading;
}

}  // namespace tendon::recording
