#include <gcm_gui/plot/canvas/cursor_lines.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <qwt_scale_map.h>

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kCursorLayer = 40;  // above the curves
constexpr std::size_t kMaxLines = 8;

QString NameOf(Cursor cursor) { return cursor == Cursor::kA ? "A" : "B"; }

// Returns the change between two numbers as text. For states, it has both names: "off → manual".
QString ChangeText(const Curve& curve, const ExactNumber& from, const ExactNumber& to) {
  if (const ValueNames* names = curve.names()) {
    const QString at_end = names->textOf(to);
    return from == to ? at_end : names->textOf(from) + QStringLiteral(" → ") + at_end;
  }
  const QString difference = from.isInteger() && from.kind() == to.kind()
                                 ? DifferenceText(from, to)
                                 : QString::number(to.nearest() - from.nearest(), 'g', 4);
  return QString("Δ %1 %2").arg(difference, curve.shownUnit()).trimmed();
}

}  // namespace

QString SpanText(double seconds) {
  const double size = std::abs(seconds);
  const bool short_one = size < 1;
  QString text = short_one ? QString("Δt %1 ms").arg(seconds * 1e3, 0, 'f', 3)
                           : QString("Δt %1 s").arg(seconds, 0, 'f', 3);
  if (size > 0) text += QString(" · %1 Hz").arg(1 / size, 0, 'g', 3);
  return text;
}

CursorLines::CursorLines(const CurveSet& curves, const TimeWindow& window, const Cursors& cursors)
    : curves_(curves), window_(window), cursors_(cursors) {
  setZ(kCursorLayer);
  setItemAttribute(Legend, false);
  setItemAttribute(AutoScale, false);
}

std::vector<CursorLines::Line> CursorLines::lines() const {
  std::vector<Line> lines;
  if (!cursors_.both()) return lines;
  const Theme& theme = Theme::instance();
  lines.push_back({SpanText(cursors_.span()), theme.color(Token::kText)});
  for (const auto& curve : curves_.curves()) {
    const auto a = curve->numberAt(*cursors_.time(Cursor::kA));
    const auto b = curve->numberAt(*cursors_.time(Cursor::kB));
    if (!curve->isVisible() || !a || !b) continue;
    if (lines.size() > kMaxLines) break;
    const QString of =
        curve->isRecorded() ? QStringLiteral(" · ") + RecordingName(curve->path()) : QString();
    lines.push_back({ChangeText(*curve, *a, *b) + of, theme.curve(curve->colorIndex())});
  }
  return lines;
}

void CursorLines::draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap&,
                       const QRectF& canvas_rect) const {
  const Theme& theme = Theme::instance();
  painter->save();
  painter->setFont(theme.small());
  const QFontMetricsF metrics(theme.small());
  for (const Cursor cursor : kCursors) {
    const auto time = cursors_.time(cursor);
    if (!time) continue;
    const double x = std::round(x_map.transform(window_.pointOf(*time)));
    if (x < canvas_rect.left() || x > canvas_rect.right()) continue;
    painter->setPen(theme.color(Token::kText, 0.7));
    painter->drawLine(QPointF(x, canvas_rect.top()), QPointF(x, canvas_rect.bottom()));
    painter->setPen(theme.color(Token::kText));
    painter->drawText(QPointF(x + kGrid, canvas_rect.top() + metrics.ascent() + 2), NameOf(cursor));
    if (cursor == Cursor::kB) drawBox(*painter, x, canvas_rect);
  }
  painter->restore();
}

void CursorLines::drawBox(QPainter& painter, double x, const QRectF& canvas_rect) const {
  const std::vector<Line> lines = this->lines();
  if (lines.empty()) return;
  const Theme& theme = Theme::instance();
  painter.setFont(theme.smallMono());
  const QFontMetricsF metrics(theme.smallMono());
  double width = 0;
  for (const Line& line : lines) width = std::max(width, metrics.horizontalAdvance(line.text));
  width += 4 * kGrid;
  const double height = static_cast<double>(lines.size()) * metrics.height() + 2 * kGrid;
  const bool fits = x + kGrid + width < canvas_rect.right();
  const QRectF box(fits ? x + kGrid : x - kGrid - width, canvas_rect.bottom() - height - 22, width,
                   height);
  painter.setPen(theme.color(Token::kLine));
  painter.setBrush(theme.color(Token::kPanel, 0.94));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.drawRoundedRect(box, kGrid, kGrid);
  painter.setRenderHint(QPainter::Antialiasing, false);
  QRectF row(box.left() + 2 * kGrid, box.top() + kGrid, width, metrics.height());
  for (const Line& line : lines) {
    painter.setPen(line.color);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, line.text);
    row.translate(0, metrics.height());
  }
}

}  // namespace tendon::gui
