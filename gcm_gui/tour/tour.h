#pragma once

#include <QList>
#include <QPointer>
#include <QRect>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

namespace tendon::gui {

class TourCard;

/// One thing that a tour points at.
struct TourStep {
  QString title;
  QString text;  ///< one sentence
  /// Opens the page that it is on, and returns it. What cannot be seen then, or is null, is left
  /// out of the tour.
  std::function<QWidget*()> target;
};

/// Shows somebody around in a window: dims it, leaves a hole over one thing after the other, and
/// says beside the hole what that is for. It ends with its last step, with Escape, and when
/// anything else takes the focus; the focus then is where it was before. What it shows goes on
/// living, but does not hear the mouse meanwhile.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// Stands over the whole of `window`, which owns it. Hidden at first.
  Tour(std::vector<TourStep> steps, QWidget& window);

  /// From the first step, also while it is running.
  void start();
  void end();
  [[nodiscard]] bool isRunning() const { return !isHidden(); }
  /// What is not dimmed, in the window.
  [[nodiscard]] const QRect& hole() const { return hole_; }

 Q_SIGNALS:
  void ended();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void next();
  void back();
  /// The target of that step, seen now; else null, and the step is left out.
  [[nodiscard]] QWidget* reach(std::size_t step);
  void showStep(std::size_t step, QWidget& target);
  void follow(QWidget* target);
  void place();
  void hearFocus(const QWidget* now);

  const std::vector<TourStep> all_;
  std::vector<TourStep> steps_;  // those of this round that can be shown, as far as that is known
  std::size_t step_ = 0;
  QWidget& window_;
  TourCard* card_;
  QPointer<QWidget> target_;
  QList<QPointer<QWidget>> followed_;  // the target and what it is in
  QPointer<QWidget> before_;           // had the focus
  QRect hole_;
};

}  // namespace tendon::gui
