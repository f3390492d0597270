#pragma once

class QAbstractScrollArea;

namespace tendon::gui {

/// Keeps the end of what grows in sight, as long as it is in sight; who scrolls up stays there.
void FollowEnd(QAbstractScrollArea& view);

}  // namespace tendon::gui
