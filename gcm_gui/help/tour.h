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
  /// Opens the page that contains the widget, and returns the widget. If the widget is null or not
  /// visible, the tour skips the step.
  std::function<QWidget*()> target;
};

/// Guides the user through a window: shows one widget after another, dims everything else, and
/// explains the widget on a card. The tour ends after the last step, with Escape, or when another
/// widget gets the focus; then the previous focus is restored. The widgets of the window are still
/// updated, but get no mouse events.
class Tour : public QWidget {
  Q_OBJECT

 public:
  /// Covers the whole of `window`, which owns the tour. Hidden until start().
  Tour(std::vector<TourStep> steps, QWidget& window);

  /// Starts at the first step; a running tour starts again.
  void start();
  void end();
  [[nodiscard]] bool isRunning() const { return !isHidden(); }
  /// The area of the present widget, which is not dimmed; in coordinates of the window.
  [[nodiscard]] const QRect& hole() const { return hole_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void next();
  void back();
  /// Returns the target of a step. If the target is not visible now, removes the step from this run
  /// and returns null.
  [[nodiscard]] QWidget* reach(std::size_t step);
  void showStep(std::size_t step, QWidget& target);
  void follow(QWidget* target);
  void place();
  void onFocusChanged(const QWidget* now);

  const std::vector<TourStep> all_;
  std::vector<TourStep> steps_;  // the steps of this run; skipped steps are removed
  std::size_t step_ = 0;
  QWidget& window_;
  TourCard* card_;
  QPointer<QWidget> target_;
  QList<QPointer<QWidget>> followed_;  // the target and its parents
  QPointer<QWidget> before_;           // the widget that had the focus before
  QRect hole_;
};

}  // namespace tendon::gui
