#pragma once

#include <gcm_gui/graph/layout/graph_layout.h>

#include <QObject>
#include <QVariantAnimation>

namespace tendon::gui {

/// What stands in the graph on its way to where it is to stand, so that the eye can follow: for
/// 150 ms. What was not there before is at its place at once; so is all where the application's
/// property kStill is true. GUI thread.
class Glide : public QObject {
  Q_OBJECT

 public:
  static constexpr const char* kStill = "tendonStill";

  explicit Glide(QObject* parent = nullptr);

  /// From where all is now.
  void goTo(const Arrangement& arrangement);
  /// Without a way.
  void putAt(const Arrangement& arrangement);
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
