#include <gcm_gui/models/selection.h>

namespace tendon::gui {

void Selection::setPaths(const QStringList& paths) {
  if (paths == paths_) return;
  paths_ = paths;
  Q_EMIT changed(paths_);
}

}  // namespace tendon::gui
