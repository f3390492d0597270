#pragma once

#include <gcm_gui/session/catalogue_store.h>

#include <QTimer>

namespace tendon::gui {

/// Returns true while some changes have not been announced to the views yet.
[[nodiscard]] inline bool IsAnnouncing(const CatalogueStore& store) {
  return store.findChild<QTimer*>()->isActive();
}

}  // namespace tendon::gui
