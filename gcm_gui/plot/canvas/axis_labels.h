#pragma once

#include <gcm_gui/plot/axes/value_ticks.h>
#include <qwt_scale_draw.h>
#include <qwt_text.h>

#include <QColor>
#include <QString>

namespace tendon::gui {

/// Labels alone, without a line or ticks: the grid is enough. At least as wide as the widest label
/// so far, so that the canvas does not move when numbers change.
class AxisLabels : public QwtScaleDraw {
 public:
  AxisLabels();

  /// The distance between two labels; decides how many digits they have.
  void setStep(double step);
  /// What the labels say at these places; at others the place itself. Returns whether they were
  /// others before; then the axis is to be painted anew.
  bool setTicks(const ValueTicks& ticks);
  /// Returns whether it was another one before; then the axis is to be painted anew.
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
  /// Returns whether it was otherwise before.
  bool setLive(bool live);

 protected:
  [[nodiscard]] QString textOf(double value) const override;

 private:
  bool live_ = true;
};

}  // namespace tendon::gui
