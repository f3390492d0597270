#include <gcm_gui/plot/canvas/axis_labels.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/series/axis_range.h>

#include <algorithm>

namespace tendon::gui {
namespace {

constexpr double kLabelSpacing = 8;

}  // namespace

AxisLabels::AxisLabels() {
  enableComponent(Backbone, false);
  enableComponent(Ticks, false);
  setSpacing(kLabelSpacing);
}

void AxisLabels::setStep(double step) {
  if (step == step_) return;
  step_ = step;
  invalidateCache();
}

bool AxisLabels::setTicks(const ValueTicks& ticks) {
  step_ = ticks.step;
  if (ticks == ticks_) return false;
  ticks_ = ticks;
  invalidateCache();
  return true;
}

bool AxisLabels::setColor(const QColor& color) {
  if (color == color_) return false;
  color_ = color;
  invalidateCache();
  return true;
}

QwtText AxisLabels::label(double value) const {
  QwtText text(textOf(value));
  text.setColor(color_);
  return text;
}

QString AxisLabels::textOf(double value) const {
  const auto found = std::find(ticks_.places.begin(), ticks_.places.end(), value);
  if (found == ticks_.places.end()) return StepText(value, step_);
  return ticks_.texts[static_cast<std::size_t>(found - ticks_.places.begin())];
}

double AxisLabels::extent(const QFont& font) const {
  const double wanted = QwtScaleDraw::extent(font);
  if (orientation() == Qt::Horizontal) return wanted;
  widest_ = std::max(widest_, wanted);
  return widest_;
}

bool TimeLabels::setLive(bool live) {
  if (live == live_) return false;
  live_ = live;
  invalidateCache();
  return true;
}

QString TimeLabels::textOf(double value) const {
  const double seconds = Cleaned(value, step());
  if (seconds == 0) return live_ ? Words::tr("now") : QStringLiteral("0 s");
  if (step() >= 3600) return QString::number(seconds / 3600, 'f', 0) + " h";
  if (step() >= 60) return QString::number(seconds / 60, 'f', 0) + " min";
  if (step() < 1e-3) {
    return QString::number(seconds * 1e3, 'f', DecimalsOf(step() * 1e3)) + " ms";
  }
  return QString::number(seconds, 'f', DecimalsOf(step())) + " s";
}

}  // namespace tendon::gui
