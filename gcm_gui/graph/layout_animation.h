#pragma once

#include <gcm_gui/graph/layout/graph_layout.h>

#include <QObject>
#include <QVariantAnimation>

namespace tendon::gui {

/// Moves the items of the graph to their new positions within 150 ms, so that the user can follow.
/// New items appear at their position at once. If the property kStill of the application is true,
/// all items move at once. GUI thread.
class LayoutAnimation : public QObject {
  Q_OBJECT

 public:
  static constexpr const char* kStill = "tendonStill";

  explicit LayoutAnimation(QObject* parent = nullptr);

  /// Starts the animation from the present positions.
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
