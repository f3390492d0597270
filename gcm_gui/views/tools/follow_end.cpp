#include <gcm_gui/views/tools/follow_end.h>

#include <QAbstractScrollArea>
#include <QScrollBar>
#include <memory>

namespace tendon::gui {

void FollowEnd(QAbstractScrollArea& view) {
  QScrollBar* bar = view.verticalScrollBar();
  const auto is_at_end = std::make_shared<bool>(true);
  QObject::connect(bar, &QScrollBar::valueChanged, bar,
                   [bar, is_at_end](int value) { *is_at_end = value >= bar->maximum(); });
  QObject::connect(bar, &QScrollBar::rangeChanged, bar, [bar, is_at_end](int, int maximum) {
    if (*is_at_end) bar->setValue(maximum);
  });
}

}  // namespace tendon::gui
