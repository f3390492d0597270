#include <gcm_gui/graph/items/card_item.h>

#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kBend = 16;
constexpr double kCorner = 16;
constexpr double kCardInsetX = 12;
constexpr double kCardInsetY = 8;
constexpr double kLine = 18;
constexpr double kTextGap = 4;
constexpr int kWrappedText = static_cast<int>(Qt::AlignLeft | Qt::AlignTop) | Qt::TextWordWrap;

}  // namespace

CardItem::CardItem() {
  setZValue(4);
  setAcceptedMouseButtons(Qt::NoButton);
}

void CardItem::setTexts(const QString& title, const QStringList& lines, double widest) {
  prepareGeometryChange();
  title_ = title;
  lines_ = lines;
  const QFontMetricsF metrics(Theme::instance().text());
  double width = QFontMetricsF(Theme::instance().strong()).horizontalAdvance(title_);
  double height = kLine;
  heights_.clear();
  for (const QString& line : lines_) {
    const QRectF needed = metrics.boundingRect(QRectF(0, 0, widest, 1000), kWrappedText, line);
    width = std::max(width, needed.width());
    heights_.push_back(needed.height());
    height += kTextGap + needed.height();
  }
  size_ = QSizeF(std::ceil(width) + 2 * kCardInsetX + 2, std::ceil(height) + 2 * kCardInsetY);
}

void CardItem::place(const QPointF& corner, const QPointF& point) {
  prepareGeometryChange();
  setPos(corner);
  port_ = point - corner;
}

QPainterPath CardItem::lineToPort() const {
  // The line starts beside the port, ends at the nearest edge of the card, and is perpendicular to
  // both.
  const QPointF beside(port_.x() < 0 ? kBend : -kBend, 0);
  const bool above = port_.y() < 0;
  const bool below = port_.y() > size_.height();
  const double x = std::clamp(port_.x() + kBend, kCorner, size_.width() - kCorner);
  const double y = std::clamp(port_.y(), kCorner, size_.height() - kCorner);
  QPainterPath line;
  if (above || below) {
    const QPointF end(x, above ? 0 : size_.height());
    const QPointF out(0, above ? -2 * kBend : 2 * kBend);
    line.moveTo(port_ + QPointF(kPortRadius, 0));
    line.cubicTo(port_ + QPointF(kBend, 0), end + out, end);
  } else {
    const QPointF end(port_.x() < 0 ? 0 : size_.width(), y);
    line.moveTo(port_);
    line.cubicTo(port_ + beside, end - beside, end);
  }
  return line;
}

QRectF CardItem::boundingRect() const {
  return (QRectF({}, size_) | QRectF(port_, QSizeF(1, 1))).adjusted(-40, -2, 40, 2);
}

void CardItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* viewport) {
  ExceptionGuard::run(viewport, ViewWork::kDrawing, [&] { draw(painter); });
}

void CardItem::draw(QPainter* painter) {
  const Theme& theme = Theme::instance();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setPen(QPen(theme.color(Token::kStale), 1.5));
  painter->setBrush(Qt::NoBrush);
  painter->drawPath(lineToPort());

  painter->setPen(theme.color(Token::kLine));
  painter->setBrush(theme.color(Token::kRaised));
  painter->drawRoundedRect(QRectF({}, size_).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
  QRectF row(kCardInsetX, kCardInsetY, size_.width() - 2 * kCardInsetX, kLine);
  painter->setFont(theme.strong());
  painter->setPen(theme.color(Token::kText));
  painter->drawText(row, kWrappedText, title_);
  painter->setFont(theme.text());
  painter->setPen(theme.color(Token::kDim));
  for (qsizetype line = 0; line < lines_.size(); ++line) {
    row.moveTop(row.bottom() + kTextGap);
    row.setHeight(heights_[static_cast<std::size_t>(line)]);
    painter->drawText(row, kWrappedText, lines_[line]);
  }
}

}  // namespace tendon::gui
