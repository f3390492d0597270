#pragma once

#include <QList>
#include <QPointer>
#include <QRect>
#include <QString>
#include <QWidget>
#include <cstddef>
#include <functional>
#include <vector>

namespace tendon::gui {

class TourCard;

/// One stop of a tour.
struct TourStep {
  QString title;
  QString text;  ///< one sentence
  /// Opens the page of the widget and returns it. The tour skips the step if the widget is null or
  /// not visible.
  std::function<QWidget*()> target;
};

/// Leads the user through a window: dims it except for one widget after another, and explains each
/// on a card. Ends with the last step, with Escape, or when something else takes the focus; then
/// restores the former focus. The widgets below keep updating, but get no mouse events.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// Covers the whole of `window`, which owns it. Hidden at first.
  Tour(std::vector<TourStep> steps, QWidget& window);

  /// Starts at the first step, also while running.
  void start();
  void end();
  [[nodiscard]] bool isRunning() const { return !isHidden(); }
  /// The area that is not dimmed, in the window's coordinates.
  [[nodiscard]] const QRect& hole() const { return hole_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void next();
  void back();
  /// The target of a step if it is visible now; otherwise null, and the tour skips the step.
  [[nodiscard]] QWidget* reach(std::size_t step);
  void showStep(std::size_t step, QWidget& target);
  void follow(QWidget* target);
  void place();
  void onFocusChanged(const QWidget* now);

  const std::vector<TourStep> all_;
  std::vector<TourStep> steps_;  // of this run, without the steps known to be skipped
  std::size_t step_ = 0;
  QWidget& window_;
  TourCard* card_;
  QPointer<QWidget> target_;
  QList<QPointer<QWidget>> followed_;  // the target and its parents
  QPointer<QWidget> before_;           // had the focus before
  QRect hole_;
};

}  // namespace tendon::gui
