#include <gcm_gui/graph/items/edge_item.h>

#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/state_mark.h>
#include <gcm_gui/theme/theme.h>

#include <QCursor>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPathStroker>
#include <QStyleOptionGraphicsItem>
#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kMinBend = 36;
constexpr double kMaxBend = 160;
constexpr double kClickWidth = 12;
constexpr double kReasonWidth = 220;

Token TokenOf(EdgeItem::Look look) {
  switch (look) {
    case EdgeItem::Look::kActive:
      return Token::kOk;
    case EdgeItem::Look::kPending:
      return Token::kDim;
    case EdgeItem::Look::kFailed:
      return Token::kBad;
    case EdgeItem::Look::kStale:
      return Token::kStale;
    case EdgeItem::Look::kPreview:
      break;
  }
  return Token::kAccent;
}

QPainterPath EdgePath(const QPointF& from, const QPointF& to) {
  const double distance = std::abs(to.x() - from.x());
  // An edge that goes to the left bends more, so that it still leaves and enters the ports
  // horizontally.
  const double wanted = to.x() > from.x() ? distance / 2 : distance / 3 + kMinBend;
  const QPointF bend(std::clamp(wanted, kMinBend, kMaxBend), 0);
  QPainterPath path(from);
  path.cubicTo(from + bend, to - bend, to);
  return path;
}

}  // namespace

EdgeItem::EdgeItem() { setZValue(1); }

void EdgeItem::setEnds(const InterfaceName& required, const InterfaceName& provided) {
  name_ = required;
  required_ = ToQString(ToString(required));
  provided_ = ToQString(ToString(provided));
}

void EdgeItem::show(const QPointF& from, const QPointF& to, Look look, const QString& reason) {
  if (from == from_ && to == to_ && look == look_ && reason == reason_) return;
  prepareGeometryChange();
  from_ = from;
  to_ = to;
  path_ = EdgePath(from, to);
  look_ = look;
  reason_ = reason;
  order();
  showTip();
  isBroken() ? setCursor(Qt::PointingHandCursor) : unsetCursor();
  update();
}

void EdgeItem::setSelected(bool selected) {
  if (selected == selected_) return;
  selected_ = selected;
  order();
  update();
}

void EdgeItem::setWarning(const QString& warning) {
  if (warning == warning_) return;
  warning_ = warning;
  showTip();
  update();
}

void EdgeItem::showTip() {
  QStringList lines{required_, reason_, warning_};
  lines.removeAll(QString());
  setToolTip(lines.join('\n'));
}

void EdgeItem::setRaised(bool raised) {
  if (raised == raised_) return;
  raised_ = raised;
  order();
}

void EdgeItem::order() {
  const bool on_top = look_ == Look::kPreview || (selected_ && look_ == Look::kFailed);
  setZValue(raised_ ? kRaisedEdge : on_top ? 3 : 1);
}

QRectF EdgeItem::boundingRect() const {
  QRectF rect = path_.boundingRect().adjusted(-kClickWidth, -kClickWidth, kClickWidth, kClickWidth);
  if (!reason_.isEmpty()) {
    const QPointF middle = path_.pointAtPercent(0.5);
    rect |= QRectF(middle.x() - kReasonWidth / 2, middle.y() - 24, kReasonWidth, 24);
  }
  return rect;
}

QPainterPath EdgeItem::shape() const {
  if (look_ == Look::kPreview) return {};  // a preview receives no clicks
  QPainterPathStroker stroker;
  stroker.setWidth(kClickWidth);
  return stroker.createStroke(path_);
}

void EdgeItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* viewport) {
  ExceptionGuard::run(viewport, ViewWork::kDrawing, [&] { draw(painter); });
}

void EdgeItem::draw(QPainter* painter) {
  painter->setRenderHint(QPainter::Antialiasing);
  const bool warns = look_ == Look::kActive && !warning_.isEmpty();
  const Token token = warns                                  ? Token::kWarning
                      : selected_ && look_ != Look::kPreview ? Token::kAccent
                                                             : TokenOf(look_);
  QPen pen(Theme::instance().color(token), look_ == Look::kPreview ? 1.5 : 2);
  if (look_ != Look::kActive) pen.setDashPattern({3, 3});
  pen.setCapStyle(Qt::FlatCap);
  painter->setPen(pen);
  painter->setBrush(Qt::NoBrush);
  if (QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform()) < kFarAway) {
    painter->setRenderHint(QPainter::Antialiasing, false);
    pen.setCosmetic(true);
    pen.setWidthF(selected_ || raised_ || look_ == Look::kFailed ? 2 : 1);
    painter->setPen(pen);
    return painter->drawLine(from_, to_);
  }
  painter->drawPath(path_);
  if (look_ == Look::kFailed && !reason_.isEmpty()) paintReason(*painter);
}

void EdgeItem::paintReason(QPainter& painter) const {
  const Theme& theme = Theme::instance();
  const QFontMetricsF metrics(theme.small());
  const QString text = metrics.elidedText(reason_, Qt::ElideRight, kReasonWidth - 16);
  const double room = to_.x() - from_.x();
  if (room < metrics.horizontalAdvance(text) + 24 && !selected_) {
    // There is no room between the nodes, so only the mark is drawn. The reason appears when the
    // edge is selected.
    const QRectF disc(path_.pointAtPercent(0.5) - QPointF(9, 9), QSizeF(18, 18));
    painter.setPen(theme.color(Token::kBad, 0.6));
    painter.setBrush(theme.color(Token::kPanel));
    painter.drawEllipse(disc);
    return PaintMark(painter, disc, StateMark::kRefused);
  }
  QRectF rect(0, 0, metrics.horizontalAdvance(text) + 12, 18);
  rect.moveCenter(path_.pointAtPercent(0.5) - QPointF(0, 14));
  painter.setPen(theme.color(Token::kBad, 0.6));
  painter.setBrush(theme.color(Token::kPanel));
  painter.drawRoundedRect(rect, 4, 4);
  painter.setFont(theme.small());
  painter.setPen(theme.color(Token::kBad));
  painter.drawText(rect, Qt::AlignCenter, text);
}

}  // namespace tendon::gui
