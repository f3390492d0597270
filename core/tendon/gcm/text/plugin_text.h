#pragma once

#include <tendon/manager/component_description.h>

#include <optional>
#include <string>

namespace tendon {

/// Describes the loaded version of a plug-in: "/opt/robot/arm.so of 2025-11-21 15:40:03".
[[nodiscard]] std::string PluginText(const PluginDescription& plugin);

/// Describes the change of its file since then: "written again at 2025-11-21 15:50:10", "gone";
/// empty if the file is unchanged.
[[nodiscard]] std::string PluginChangeText(const PluginDescription& plugin);

/// A plug-in whose file has changed.
struct OldPlugin {
  /// "process 'robot' runs /opt/robot/arm.so of 2025-11-21 15:40:03; the file was written again at
  /// 2025-11-21 15:50:10"
  std::string finding;
  std::string remedy;  ///< "restart the process to use it"
};

/// Nothing if the file is unchanged.
[[nodiscard]] std::optional<OldPlugin> FindOldPlugin(const std::string& process,
                                                     const PluginDescription& plugin);

/// Finding and remedy in one sentence: "FINDING: REMEDY". Empty if the file is unchanged.
[[nodiscard]] std::string OldPluginText(const std::string& process,
                                        const PluginDescription& plugin);

}  // namespace tendon
