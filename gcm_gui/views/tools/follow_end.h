#pragma once

class QAbstractScrollArea;

namespace tendon::gui {

/// Keeps the end of growing contents visible, unless the user has scrolled up.
void FollowEnd(QAbstractScrollArea& view);

}  // namespace tendon::gui
