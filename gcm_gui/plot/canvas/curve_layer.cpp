#include <gcm_gui/plot/canvas/curve_layer.h>

#include <gcm_gui/plot/canvas/late_samples.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_scale_map.h>

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <limits>

namespace tendon::gui {
namespace {

constexpr double kCurveLayer = 20;  // above grid and gaps
constexpr double kThickness = 2;    // logical pixels
constexpr double kDotRadius = 2.5;
constexpr double kLateRadius = 4;
// Pixels between two samples; no dots are drawn at smaller distances.
constexpr double kNearest = 3;
// The distance between samples, in pixels, from which dots have their full size.
constexpr double kDotDistance = 8;
constexpr double kBeyond = 64;  // pixels outside the canvas; lines are cut off there
constexpr double kDash = 7;     // logical pixels, of a recorded curve
constexpr double kDashGap = 4;

QwtScaleMap OnAxis(QwtScaleMap map, const AxisRange& range) {
  map.setScaleInterval(range.low, range.high);
  return map;
}

/// The dashes of a recorded curve. They belong to times, so that they move with the curve.
Dashes DashesOf(const Curve& curve, const TimeSlices& slices, double ratio) {
  const auto columns = static_cast<std::int64_t>(slices.count / SpanRaster::kSlicesPerColumn);
  if (!curve.isRecorded() || columns == 0) return {};
  const double width_ns =
      static_cast<double>(slices.to_ns - slices.from_ns) / static_cast<double>(columns);
  const auto from_ns = static_cast<double>(MovedTime(slices.from_ns, -curve.shift()));
  return {.dash = static_cast<int>(std::lround(kDash * ratio)),
          .gap = static_cast<int>(std::lround(kDashGap * ratio)),
          .first = std::llround(from_ns / std::max(width_ns, 1.0))};
}

}  // namespace

CurveLayer::CurveLayer(const CurveSet& curves, const TimeWindow& window)
    : curves_(curves), window_(window) {
  setZ(kCurveLayer);
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
  const bool is_former = window_.isSweeping() && x_map.s1() < window_.from();
  const Pass pass = is_former ? Pass::kFormer : Pass::kPresent;
  const bool is_vector = painter->paintEngine()->type() == QPaintEngine::SVG;
  raster_.begin((canvas_rect.size() * ratio).expandedTo({1, 1}).toSize());
  for (const auto& curve : curves_.curves()) {
    if (!curve->isVisible()) continue;
    const UnitAxis& axis = curves_.axisOf(*curve);
    const QwtScaleMap map = OnAxis(y_map, axis.range);
    if (is_vector) {
      drawLines(*painter, *curve, curve->envelope(slices, pass), map, axis.frame, canvas_rect);
      continue;
    }
    const RowScale rows{.low = axis.range.low,
                        .scale = (map.p2() - map.p1()) / axis.range.span() * ratio,
                        .offset = (map.transform(axis.range.low) - canvas_rect.top()) * ratio,
                        .factor = axis.frame.factor(),
                        .values = curves_.scale()};
    raster_.draw(curve->envelope(slices, pass), rows, kThickness / 2 * ratio,
                 Theme::instance().curve(curve->colorIndex()), DashesOf(*curve, slices, ratio));
  }
  if (!is_vector) raster_.paint(*painter, canvas_rect.topLeft(), ratio);
  for (const auto& curve : curves_.curves()) {
    if (curve->isVisible()) drawDots(*painter, *curve, x_map, y_map, canvas_rect);
  }
}

double CurveLayer::rowOf(double distance, const AxisFrame& frame, const QwtScaleMap& map,
                         const QRectF& rect) const {
  const double place = frame.placeOf(distance, curves_.scale());
  if (place == -std::numeric_limits<double>::infinity()) return rect.bottom();
  return std::clamp(map.transform(place), rect.top() - kBeyond, rect.bottom() + kBeyond);
}

// Draws an envelope into a scalable picture: a line from the minimum to the maximum of each slice.
void CurveLayer::drawLines(QPainter& painter, const Curve& curve, const Envelope& envelope,
                           const QwtScaleMap& map, const AxisFrame& frame,
                           const QRectF& rect) const {
  const double step = rect.width() / static_cast<double>(envelope.low().size());
  QPainterPath path;
  bool is_open = false;
  for (std::size_t i = 0; i < envelope.low().size(); ++i) {
    if (envelope.low()[i] > envelope.high()[i]) {
      is_open = false;
      continue;
    }
    const double x = rect.left() + (static_cast<double>(i) + 0.5) * step;
    const QPointF low(x, rowOf(envelope.low()[i], frame, map, rect));
    is_open ? path.lineTo(low) : path.moveTo(low);
    path.lineTo(x, rowOf(envelope.high()[i], frame, map, rect));
    is_open = true;
  }
  painter.save();
  painter.setClipRect(rect);
  painter.setBrush(Qt::NoBrush);
  QPen pen(Theme::instance().curve(curve.colorIndex()), kThickness, Qt::SolidLine, Qt::RoundCap,
           Qt::RoundJoin);
  if (curve.isRecorded()) {
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern({kDash / kThickness, kDashGap / kThickness});
  }
  painter.setPen(pen);
  painter.drawPath(path);
  painter.restore();
}

// Returns the radius of a dot. The radius grows with the distance between samples. At the smallest
// distance, the radius is half the width of the line. Therefore, no dot suddenly appears or
// disappears when one more sample becomes visible.
double CurveLayer::DotRadius(double distance) {
  const double part = (distance - kNearest) / (kDotDistance - kNearest);
  return kThickness / 2 + std::clamp(part, 0.0, 1.0) * (kDotRadius - kThickness / 2);
}

void CurveLayer::drawDots(QPainter& painter, const Curve& curve, const QwtScaleMap& x_map,
                          const QwtScaleMap& y_map, const QRectF& rect) const {
  const SampleRing& samples = curve.samples();
  const std::int64_t from = window_.timeAt(x_map.invTransform(rect.left()));
  const std::int64_t to = window_.timeAt(x_map.invTransform(rect.right()));
  const std::uint64_t first = samples.lowerBound(from);
  const std::uint64_t end = samples.lowerBound(to);
  if (first == end) return;
  const double width_ns = static_cast<double>(to - from);
  const auto x_of = [&](std::uint64_t i) {
    return rect.left() + static_cast<double>(samples.time(i) - from) / width_ns * rect.width();
  };
  const auto between = static_cast<double>(std::max<std::uint64_t>(end - first - 1, 1));
  const double distance = end - first > 1 ? (x_of(end - 1) - x_of(first)) / between : kDotDistance;
  if (distance < kNearest) return;
  const UnitAxis& axis = curves_.axisOf(curve);
  const QwtScaleMap map = OnAxis(y_map, axis.range);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = Theme::instance().curve(curve.colorIndex());
  // The dots of a recorded curve are rings.
  painter.setPen(curve.isRecorded() ? QPen(color, 1) : QPen(Qt::NoPen));
  const QColor inside = curve.isRecorded() ? Theme::instance().color(Token::kPanel) : color;
  for (std::uint64_t i = first; i < end; ++i) {
    const double from_base = curve.distanceOf(i);
    if (!std::isfinite(from_base)) continue;
    const bool is_late = IsLate(samples, i);
    painter.setBrush(is_late ? Theme::instance().color(Token::kWarning) : inside);
    const double radius = is_late ? kLateRadius : DotRadius(distance);
    const double y = rowOf(from_base, axis.frame, map, rect);
    painter.drawEllipse(QPointF(x_of(i), y), radius, radius);
  }
  painter.restore();
}

}  // namespace tendon::gui
