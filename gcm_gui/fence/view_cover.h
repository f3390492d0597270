#pragma once

#include <QPointer>
#include <QWidget>

namespace tendon::gui {

/// Stands in a view's place while the view cannot be drawn, says so, and offers to try again.
class ViewCover : public QWidget {
  Q_OBJECT

 public:
  /// A child of `view`, over all of it.
  explicit ViewCover(QWidget& view);

  /// Hides it, and gives the focus back to the view where it has it.
  void leave();

 Q_SIGNALS:
  void shownAgainRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace tendon::gui
