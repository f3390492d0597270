#pragma once

#include <gcm_gui/plot/canvas/value_ticks.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <QColor>
#include <QString>

namespace tendon::gui {

/// Labels without line or ticks, because there is a grid. The width never shrinks, so the canvas
/// does not move when numbers change.
class AxisLabels : public QwtScaleDraw {
 public:
  AxisLabels();

  /// Sets the distance between two labels, which decides the number of digits.
  void setStep(double step);
  /// Sets the texts of the labels; a place without a text shows the number. Returns true if
  /// something changed and the axis needs a repaint.
  bool setTicks(const ValueTicks& ticks);
  /// Returns true if the colour changed and the axis needs a repaint.
  bool setColor(const QColor& color);
  [[nodiscard]] const QColor& color() const { return color_; }

  [[nodiscard]] QwtText label(double value) const final;
  [[nodiscard]] double extent(const QFont& font) const override;

 protected:
  [[nodiscard]] double step() const { return step_; }
  [[nodiscard]] virtual QString textOf(double value) const;

 private:
  double step_ = 1;
  ValueTicks ticks_;
  QColor color_;
  mutable double widest_ = 0;
};

/// "-25 s", "-2 min", and "now" at 0 while the plot is live.
class TimeLabels final : public AxisLabels {
 public:
  /// Returns true if it changed.
  bool setLive(bool live);

 protected:
  [[nodiscard]] QString textOf(double value) const override;

 private:
  bool live_ = true;
};

}  // namespace tendon::gui
