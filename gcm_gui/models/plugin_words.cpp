#include <gcm_gui/models/plugin_words.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/text.h>

namespace tendon::gui {

QString PluginWords(const PluginDescription& plugin) {
  const QString name = ToQString(plugin.file).section('/', -1);
  return Words::tr("%1 of %2", "a file, and when it was written")
      .arg(name, ToQString(WallTimeText(plugin.written)));
}

QString PluginChangeWords(const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return {};
  if (plugin.state == PluginState::kGone) {
    return Words::tr("the file is missing: restore the file before you restart the process");
  }
  return Words::tr("the file was written again at %1: restart the process to use the new file")
      .arg(ToQString(WallTimeText(plugin.written_now)));
}

QString OldPluginWords(const QString& process, const PluginDescription& plugin) {
  if (plugin.state == PluginState::kCurrent) return {};
  return process + Words::tr(" runs ") + PluginWords(plugin) + QStringLiteral("; ") +
         PluginChangeWords(plugin);
}

}  // namespace tendon::gui
