#pragma once

#include <QAbstractSlider>
#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

namespace tendon::gui {

/// The whole length of a recording as a line. It shows the present moment and the places of events,
/// losses and marks. The user goes to another moment with a click, by dragging, or with keys. All
/// times are in ns.
class TimeSlider final : public QAbstractSlider {
  Q_OBJECT

 public:
  struct Span {
    std::int64_t from = 0;
    std::int64_t to = 0;
  };

  explicit TimeSlider(QWidget* parent = nullptr);

  void setRange(std::int64_t first, std::int64_t last);
  void setEvents(std::vector<Span> spans);
  void setLosses(std::vector<Span> spans);
  void setMarks(std::vector<Span> spans);
  void setTime(std::int64_t time);
  [[nodiscard]] std::int64_t time() const { return time_; }
  /// Return the time at a column of the widget, or the column of a time.
  [[nodiscard]] std::int64_t timeAt(double x) const;
  [[nodiscard]] double xOf(std::int64_t time) const;

  [[nodiscard]] QSize sizeHint() const override { return {320, 32}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {80, 32}; }

 Q_SIGNALS:
  /// The user has chosen a moment. Also emitted while dragging.
  void sought(qint64 time);
  /// The user has pressed the left (-1) or right (1) arrow key.
  void stepRequested(int direction);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  /// For each column of the widget: true if it shows a span.
  [[nodiscard]] std::vector<bool> columnsOf(const std::vector<Span>& spans) const;
  void findColumns();
  void seekTo(std::int64_t time);

  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t time_ = 0;
  std::int64_t unit_ = 1'000'000;  // of the value for screen readers
  std::vector<Span> events_;
  std::vector<Span> losses_;
  std::vector<Span> marks_;
  std::vector<bool> event_columns_;
  std::vector<bool> loss_columns_;
  std::optional<double> hover_;
};

/// Returns the time since the start of the recording as text: "1:02.345", "1:02:05.120".
[[nodiscard]] QString MomentText(std::int64_t since_begin_ns);

}  // namespace tendon::gui
