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

std::string OldPluginText(const std::string& process, const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return "";
  const bool is_gone = plugin.state == PluginState::kGone;
  return "process '" + process + "' runs " + PluginText(plugin) + "; the file " +
         (is_gone ? "is gone: put it back before the process is started anew"
                  : "was " + PluginChangeText(plugin) + ": start the process anew to run that");
}

}  // namespace tendon
