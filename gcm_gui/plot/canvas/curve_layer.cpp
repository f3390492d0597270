#include <gcm_gui/plot/canvas/curve_layer.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_scale_map.h>

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <cmath>
#include <limits>

namespace tendon::gui {
namespace {

constexpr double kZ = 20;         // above grid and gaps
constexpr double kThickness = 2;  // logical pixels
constexpr double kDotRadius = 2.5;
constexpr double kLateRadius = 4;
constexpr double kLate = 1.5;       // periods after the one before
constexpr double kDotDistance = 8;  // samples as far apart as this are shown one by one

QwtScaleMap OnAxis(QwtScaleMap map, const AxisRange& range) {
  map.setScaleInterval(range.low, range.high);
  return map;
}

}  // namespace

CurveLayer::CurveLayer(const CurveSet& curves, const TimeWindow& window)
    : curves_(curves), window_(window) {
  setZ(kZ);
  setItemAttribute(Legend, false);
  setItemAttribute(AutoScale, false);
}

TimeSlices CurveLayer::slicesOf(const QwtScaleMap& x_map, const QRectF& rect,
                                double device_pixel_ratio) const {
  const double columns = std::ceil(rect.width() * device_pixel_ratio);
  const double right = rect.left() + columns / device_pixel_ratio;
  return {.from_ns = window_.timeAt(x_map.invTransform(rect.left())),
          .to_ns = window_.timeAt(x_map.invTransform(right)),
          .count = static_cast<std::size_t>(columns) * SpanRaster::kSlicesPerColumn};
}

void CurveLayer::draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
                      const QRectF& canvas_rect) const {
  const double ratio = painter->device()->devicePixelRatioF();
  const TimeSlices slices = slicesOf(x_map, canvas_rect, ratio);
  const bool is_vector = painter->paintEngine()->type() == QPaintEngine::SVG;
  raster_.begin((canvas_rect.size() * ratio).expandedTo({1, 1}).toSize());
  for (const auto& curve : curves_.curves()) {
    if (!curve->isVisible()) continue;
    const QwtScaleMap map = OnAxis(y_map, curves_.axisOf(*curve).range);
    const double at_zero = (map.transform(0) - canvas_rect.top()) * ratio;
    const double at_one = (map.transform(1) - canvas_rect.top()) * ratio;
    if (is_vector) {
      drawLines(*painter, *curve, slices, map, canvas_rect);
      continue;
    }
    raster_.draw(curve->envelope(slices), {.scale = at_one - at_zero, .offset = at_zero},
                 kThickness / 2 * ratio, Theme::instance().curve(curve->colorIndex()));
  }
  if (!is_vector) raster_.paint(*painter, canvas_rect.topLeft(), ratio);
  for (const auto& curve : curves_.curves()) {
    if (curve->isVisible()) drawDots(*painter, *curve, x_map, y_map, canvas_rect);
  }
}

// For pictures that can be scaled: from each slice's lowest value to its highest.
void CurveLayer::drawLines(QPainter& painter, const Curve& curve, const TimeSlices& slices,
                           const QwtScaleMap& map, const QRectF& rect) {
  const Envelope& envelope = curve.envelope(slices);
  const double step = rect.width() / static_cast<double>(slices.count);
  QPainterPath path;
  bool is_open = false;
  for (std::size_t i = 0; i < envelope.low().size(); ++i) {
    if (envelope.low()[i] > envelope.high()[i]) {
      is_open = false;
      continue;
    }
    const double x = rect.left() + (static_cast<double>(i) + 0.5) * step;
    const QPointF low(x, map.transform(envelope.low()[i]));
    is_open ? path.lineTo(low) : path.moveTo(low);
    path.lineTo(x, map.transform(envelope.high()[i]));
    is_open = true;
  }
  painter.save();
  painter.setClipRect(rect);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Theme::instance().curve(curve.colorIndex()), kThickness, Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.restore();
}

void CurveLayer::drawDots(QPainter& painter, const Curve& curve, const QwtScaleMap& x_map,
                          const QwtScaleMap& y_map, const QRectF& rect) const {
  const SampleRing& samples = curve.samples();
  const std::int64_t from = window_.timeAt(x_map.invTransform(rect.left()));
  const std::int64_t to = window_.timeAt(x_map.invTransform(rect.right()));
  const std::uint64_t first = samples.lowerBound(from);
  const std::uint64_t end = samples.lowerBound(to);
  if (static_cast<double>(end - first) * kDotDistance > rect.width()) return;
  const QwtScaleMap map = OnAxis(y_map, curves_.axisOf(curve).range);
  const double width_ns = static_cast<double>(to - from);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  const double rate = curve.rate();
  const double late_ns = rate > 0 ? kLate * 1e9 / rate : std::numeric_limits<double>::infinity();
  const QColor color = Theme::instance().curve(curve.colorIndex());
  for (std::uint64_t i = first; i < end; ++i) {
    if (!std::isfinite(samples.value(i))) continue;
    const bool is_late = i > samples.firstIndex() &&
                         static_cast<double>(samples.time(i) - samples.time(i - 1)) > late_ns;
    painter.setBrush(is_late ? Theme::instance().color(Token::kWarning) : color);
    const double x = static_cast<double>(samples.time(i) - from) / width_ns * rect.width();
    const double radius = is_late ? kLateRadius : kDotRadius;
    painter.drawEllipse(QPointF(rect.left() + x, map.transform(samples.value(i))), radius, radius);
  }
  painter.restore();
}

}  // namespace tendon::gui
