#pragma once

#include <tendon/manager/component_description.h>

#include <QString>

namespace tendon::gui {

/// The version of a plug-in that is running, without folder: "arm.so of 2025-11-21 15:40:03".
[[nodiscard]] QString PluginWords(const PluginDescription& plugin);

/// The difference of its file from the running code, and the remedy; empty if there is none.
[[nodiscard]] QString PluginChangeWords(const PluginDescription& plugin);

/// The same as a sentence about the process.
[[nodiscard]] QString OldPluginWords(const QString& process, const PluginDescription& plugin);

}  // namespace tendon::gui
