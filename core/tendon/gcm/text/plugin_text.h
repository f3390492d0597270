#pragma once

#include <tendon/manager/description.h>

#include <string>

namespace tendon {

/// What runs of a plug-in: "/opt/robot/arm.so of 2025-11-21 15:40:03".
[[nodiscard]] std::string PluginText(const PluginDescription& plugin);

/// What has become of its file since: "written again at 2025-11-21 15:50:10", "gone"; empty where
/// that has what runs.
[[nodiscard]] std::string PluginChangeText(const PluginDescription& plugin);

/// One sentence for a plug-in whose file has not what runs, with what to do: "process 'robot' runs
/// /opt/robot/arm.so of 2025-11-21 15:40:03; the file was written again at 2025-11-21 15:50:10:
/// start the process anew to run that". Empty where the file has what runs.
[[nodiscard]] std::string OldPluginText(const std::string& process,
                                        const PluginDescription& plugin);

}  // namespace tendon
