#pragma once

#include <QWidget>
#include <cstddef>

namespace tendon::gui {

/// How much of the memory for samples is in use, as a bar of a few pixels; in words where the mouse
/// rests.
class MemoryMeter : public QWidget {
  Q_OBJECT

 public:
  explicit MemoryMeter(QWidget* parent = nullptr);

  /// In bytes. `is_thinned`: the oldest part is kept as extremes.
  void setFigures(std::size_t used, std::size_t budget, bool is_thinned);
  [[nodiscard]] QSize sizeHint() const override { return {36, 16}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double part_ = 0;
  bool is_thinned_ = false;
};

}  // namespace tendon::gui
