#pragma once

#include <QPointer>
#include <QWidget>

namespace tendon::gui {

/// Covers a view that cannot be painted, and shows a text and a button for a retry.
class ViewCover : public QWidget {
  Q_OBJECT

 public:
  /// A child of `view` that covers all of it.
  explicit ViewCover(QWidget& view);

  /// Hides the cover, and returns the focus to the view if the cover has it.
  void leave();

 Q_SIGNALS:
  void shownAgainRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace tendon::gui
