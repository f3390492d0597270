#pragma once

#include <QWidget>
#include <cstddef>

namespace tendon::gui {

/// Shows how much of the sample memory is used, as a bar of a few pixels; the tool tip says it in
/// words.
class MemoryMeter : public QWidget {
  Q_OBJECT

 public:
  explicit MemoryMeter(QWidget* parent = nullptr);

  /// In bytes. `is_thinned`: the oldest part is kept as minima and maxima only.
  void setFigures(std::size_t used, std::size_t budget, bool is_thinned);
  [[nodiscard]] QSize sizeHint() const override { return {36, 16}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double part_ = 0;
  bool is_thinned_ = false;
};

}  // namespace tendon::gui
