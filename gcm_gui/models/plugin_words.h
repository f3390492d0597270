#pragma once

#include <tendon/manager/component_description.h>

#include <QString>

namespace tendon::gui {

/// Returns the name (without folder) and the version of a plug-in that is running: "arm.so of
/// 2025-11-21 15:40:03".
[[nodiscard]] QString PluginWords(const PluginDescription& plugin);

/// Returns how the plug-in's file differs from the running code, and the remedy. Returns an empty
/// text if they do not differ.
[[nodiscard]] QString PluginChangeWords(const PluginDescription& plugin);

/// Returns the text of PluginChangeWords() as a sentence about the process.
[[nodiscard]] QString OldPluginWords(const QString& process, const PluginDescription& plugin);

}  // namespace tendon::gui
