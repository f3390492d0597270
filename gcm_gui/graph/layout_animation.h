#pragma once

#include <gcm_gui/graph/layout/graph_layout.h>

#include <QObject>
#include <QVariantAnimation>

namespace tendon::gui {

/// Moves the items of the graph to their new positions in 150 ms, so that the eye can follow. New
/// items appear at their position at once; if the application's property kStill is true, all items
/// do. GUI thread.
class LayoutAnimation : public QObject {
  Q_OBJECT

 public:
  static constexpr const char* kStill = "tendonStill";

  explicit LayoutAnimation(QObject* parent = nullptr);

  /// Starts from the present positions.
  void goTo(const Arrangement& arrangement);
  /// Moves everything without an animation.
  void jumpTo(const Arrangement& arrangement);
  [[nodiscard]] const Arrangement& now() const { return now_; }
  [[nodiscard]] bool isOver() const { return way_.state() != QAbstractAnimation::Running; }

 Q_SIGNALS:
  void moved();

 private:
  void show(double part);

  QVariantAnimation way_;
  Arrangement from_;
  Arrangement to_;
  Arrangement now_;
};

}  // namespace tendon::gui
