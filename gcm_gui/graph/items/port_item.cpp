#include <gcm_gui/graph/items/port_item.h>

#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <QPainterPath>
#include <QStyleOptionGraphicsItem>

namespace tendon::gui {
namespace {

constexpr double kInnerRing = 10;
constexpr double kOuterRing = 14;
static_assert(kOuterRing + 1 < kPortInset, "the rings of a port would touch its name");
constexpr double kBadge = 16;
constexpr double kHalfPitch = kPortPitch / 2;

}  // namespace

PortItem::PortItem(QGraphicsItem* parent) : QGraphicsItem(parent) {
  setAcceptHoverEvents(true);
  setCursor(Qt::PointingHandCursor);
}

void PortItem::show(const PortPicture& picture, double node_width, bool stale) {
  prepareGeometryChange();
  picture_ = picture;
  label_ = ToQString(picture.port.name.interface);
  node_width_ = node_width;
  stale_ = stale;
  setToolTip(ToQString(ToString(picture.port.name)));
  update();
}

void PortItem::setRole(Role role, int number) {
  if (role == role_ && number == number_) return;
  prepareGeometryChange();
  role_ = role;
  number_ = number;
  setZValue(role == Role::kPlain || role == Role::kUnfit ? 0 : 1);
  setOpacity(role == Role::kUnfit ? 0.5 : 1.0);
  update();
}

QRectF PortItem::clickRect() const {
  const double half = node_width_ / 2;
  const bool left = picture_.port.side == Side::kRequired;
  return left ? QRectF(-kHalfPitch, -kHalfPitch, half + kHalfPitch, kPortPitch)
              : QRectF(-half, -kHalfPitch, half + kHalfPitch, kPortPitch);
}

QRectF PortItem::boundingRect() const {
  const double reach = kOuterRing + 2;
  const QRectF rings(-reach - kBadge, -reach - kBadge, 2 * (reach + kBadge), 2 * reach + kBadge);
  return clickRect() | rings;
}

QPainterPath PortItem::shape() const {
  QPainterPath path;
  path.addRect(clickRect());
  return path;
}

void PortItem::hoverEnterEvent(QGraphicsSceneHoverEvent*) {
  hovered_ = true;
  update();
}

void PortItem::hoverLeaveEvent(QGraphicsSceneHoverEvent*) {
  hovered_ = false;
  update();
}

void PortItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* viewport) {
  ExceptionGuard::run(viewport, ViewWork::kDrawing, [&] { draw(painter); });
}

void PortItem::draw(QPainter* painter) {
  painter->setRenderHint(QPainter::Antialiasing);
  const Theme& theme = Theme::instance();
  const bool lively = role_ == Role::kChosen || role_ == Role::kCandidate || hovered_;
  painter->setFont(theme.text());
  painter->setPen(theme.color(lively && !stale_ ? Token::kText : Token::kDim));
  const bool left = picture_.port.side == Side::kRequired;
  const QRectF text = left
                          ? QRectF(kPortInset, -kHalfPitch, node_width_, kPortPitch)
                          : QRectF(-node_width_, -kHalfPitch, node_width_ - kPortInset, kPortPitch);
  painter->drawText(text,
                    static_cast<int>((left ? Qt::AlignLeft : Qt::AlignRight)) | Qt::AlignVCenter |
                        Qt::TextSingleLine,
                    label_);
  if (role_ == Role::kChosen || role_ == Role::kCandidate) paintRings(*painter);
  paintDisc(*painter);
}

void PortItem::paintDisc(QPainter& painter) const {
  const Theme& theme = Theme::instance();
  const QColor color = theme.color(stale_ ? Token::kStale : Token::kAccent);
  const bool filled = picture_.port.side == Side::kProvided || picture_.connected;
  const double grown = hovered_ && role_ != Role::kUnfit ? 1 : 0;
  painter.setPen(QPen(color, 2));
  painter.setBrush(filled ? color : theme.color(Token::kCanvas));
  painter.drawEllipse(QPointF(), kPortRadius - 1 + grown, kPortRadius - 1 + grown);
}

void PortItem::paintRings(QPainter& painter) const {
  const Theme& theme = Theme::instance();
  painter.setBrush(Qt::NoBrush);
  if (role_ == Role::kChosen) {
    painter.setPen(QPen(theme.color(Token::kAccent), 2));
    painter.drawEllipse(QPointF(), kInnerRing - 1, kInnerRing - 1);
    return;
  }
  painter.setPen(QPen(theme.color(Token::kAccent, 0.8), 2));
  painter.drawEllipse(QPointF(), kInnerRing, kInnerRing);
  painter.setPen(QPen(theme.color(Token::kAccent, 0.35), 1));
  painter.drawEllipse(QPointF(), kOuterRing, kOuterRing);
  if (number_ == 0) return;
  // The badge is outside the node, so that it does not hide the name.
  const bool left = picture_.port.side == Side::kRequired;
  const QRectF badge(left ? -8 - kBadge : 8, -8 - kBadge - 2, kBadge, kBadge);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.color(Token::kAccent));
  painter.drawRoundedRect(badge, 4, 4);
  QFont font = theme.small();
  font.setWeight(QFont::Bold);
  painter.setFont(font);
  painter.setPen(theme.color(Token::kOnAccent));
  painter.drawText(badge, Qt::AlignCenter, QString::number(number_));
}

}  // namespace tendon::gui
