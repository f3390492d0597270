#pragma once

#include <tendon/manager/description.h>

#include <QString>

namespace tendon::gui {

/// What runs of a plug-in: "arm.so of 2025-11-21 15:40:03", without its folder.
[[nodiscard]] QString PluginWords(const PluginDescription& plugin);

/// What has become of its file since, and what to do; empty where the file has what runs.
[[nodiscard]] QString PluginChangeWords(const PluginDescription& plugin);

/// The same as one sentence about the process.
[[nodiscard]] QString OldPluginWords(const QString& process, const PluginDescription& plugin);

}  // namespace tendon::gui
