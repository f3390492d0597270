#include <tendon/gcm/text/plugin_text.h>
#include <tendon/gcm/text/wall_time.h>

namespace tendon {

std::string PluginText(const PluginDescription& plugin) {
  return plugin.file + " of " + WallTimeText(plugin.written);
}

std::string PluginChangeText(const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return "";
  if (plugin.state == PluginState::kGone) return "gone";
  return "written again at " + WallTimeText(plugin.written_now);
}

std::optional<OldPlugin> FindOldPlugin(const std::string& process,
                                       const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return std::nullopt;
  const bool is_gone = plugin.state == PluginState::kGone;
  return OldPlugin{.finding = "process '" + process + "' runs " + PluginText(plugin) +
                              "; the file " +
                              (is_gone ? "is missing" : "was " + PluginChangeText(plugin)),
                   .remedy = is_gone ? "restore it before you restart the process"
                                     : "restart the process to use it"};
}

std::string OldPluginText(const std::string& process, const PluginDescription& plugin) {
  const auto old = FindOldPlugin(process, plugin);
  return old ? old->finding + ": " + old->remedy : "";
}

}  // namespace tendon
