#pragma once

#include <QWidget>
#include <cstddef>

namespace tendon::gui {

/// Shows how much of the memory for samples is used, as a bar a few pixels high. The tool tip
/// contains the same information in words.
class MemoryMeter : public QWidget {
  Q_OBJECT

 public:
  explicit MemoryMeter(QWidget* parent = nullptr);

  /// Sets the used and the available memory in bytes. `is_thinned` is true if the oldest samples
  /// are kept only as minima and maxima.
  void setFigures(std::size_t used, std::size_t budget, bool is_thinned);
  [[nodiscard]] QSize sizeHint() const override { return {36, 16}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double part_ = 0;
  bool is_thinned_ = false;
};

}  // namespace tendon::gui
