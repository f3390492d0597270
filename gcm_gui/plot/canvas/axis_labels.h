#pragma once

#include <gcm_gui/plot/canvas/value_ticks.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <QColor>
#include <QString>

namespace tendon::gui {

/// The labels of an axis, without a line and without tick marks, because the plot has a grid. The
/// width never shrinks, so the canvas does not move when numbers change.
class AxisLabels : public QwtScaleDraw {
 public:
  AxisLabels();

  /// Sets the distance between two labels. It determines the number of digits.
  void setStep(double step);
  /// Sets the texts of the labels. At a position without a text, the number is shown. Returns true
  /// if something has changed, so that the axis must be repainted.
  bool setTicks(const ValueTicks& ticks);
  /// Returns true if the colour has changed, so that the axis must be repainted.
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

/// Labels of a time axis: "-25 s", "-2 min", and "now" at 0 while the plot is live.
class TimeLabels final : public AxisLabels {
 public:
  /// Sets whether the plot is live. Returns true if this has changed.
  bool setLive(bool live);

 protected:
  [[nodiscard]] QString textOf(double value) const override;

 private:
  bool live_ = true;
};

}  // namespace tendon::gui
