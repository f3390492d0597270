#include <gcm_gui/graph/items/component_item.h>

#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionGraphicsItem>

namespace tendon::gui {
namespace {

constexpr double kBar = 3;
constexpr double kStaleOpacity = 0.5;
constexpr double kUsual = 2;  // the z value when not raised

}  // namespace

ComponentItem::ComponentItem() { setZValue(kUsual); }

bool ComponentItem::show(const NodePicture& picture, const QRectF& rect, bool stale) {
  if (picture == picture_ && rect == sceneRect() && stale == stale_) return false;
  prepareGeometryChange();
  picture_ = picture;
  size_ = rect.size();
  stale_ = stale;
  setPos(rect.topLeft());
  setOpacity(stale ? kStaleOpacity : 1.0);
  const QString waits = ReasonsText(picture.waits);
  setToolTip(picture.path + QStringLiteral(" · ") + (stale ? Words::tr("was ") : QString()) +
             WordOf(MarkOf(picture.state)) +
             (waits.isEmpty() || stale ? QString()
                                       : QStringLiteral(", ") + Words::tr("waiting for ") + waits));
  std::size_t used = 0;
  showPorts(picture.required, Side::kRequired, used);
  showPorts(picture.provided, Side::kProvided, used);
  while (ports_.size() > used) {
    delete ports_.back();
    ports_.pop_back();
  }
  update();
  return true;
}

void ComponentItem::showPorts(const std::vector<PortPicture>& ports, Side side, std::size_t& used) {
  int index = 0;
  for (const PortPicture& port : ports) {
    if (used == ports_.size()) ports_.push_back(new PortItem(this));
    PortItem& item = *ports_[used++];
    item.setPos(PortCentre(QRectF({}, size_), side, index++));
    item.show(port, size_.width(), stale_);
  }
}

void ComponentItem::setSelected(bool selected) {
  if (selected == selected_) return;
  selected_ = selected;
  update();
}

void ComponentItem::setRaised(bool raised) { setZValue(raised ? kRaisedNode : kUsual); }

Token ComponentItem::token() const {
  return stale_ ? Token::kStale : ColorOf(MarkOf(picture_.state, picture_.waits));
}

QRectF ComponentItem::boundingRect() const { return QRectF({}, size_).adjusted(-1, -1, 1, 1); }

void ComponentItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* viewport) {
  ExceptionGuard::run(viewport, ViewWork::kDrawing, [&] { draw(painter); });
}

void ComponentItem::draw(QPainter* painter) {
  const Theme& theme = Theme::instance();
  const QRectF rect = QRectF({}, size_).adjusted(0.5, 0.5, -0.5, -0.5);
  const double scale =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  const bool far_away = scale < kFarAway;
  for (PortItem* port : ports_) port->setVisible(!far_away);

  painter->setRenderHint(QPainter::Antialiasing, !far_away);
  const QPen pen(theme.color(selected_ ? Token::kAccent : Token::kLine), selected_ ? 1.5 : 1);
  painter->setPen(pen);
  painter->setBrush(theme.color(Token::kRaised));
  painter->drawRoundedRect(rect, kRadius, kRadius);

  painter->setPen(Qt::NoPen);
  painter->setBrush(theme.color(token()));
  painter->drawRoundedRect(QRectF(0, 0, kBar, size_.height()), kBar / 2, kBar / 2);
  if (far_away) return;

  painter->setFont(theme.strong());
  painter->setPen(theme.color(Token::kText));
  const QRectF head(kNodeInset, 2, size_.width() - 2 * kNodeInset, kNodeHead - 2);
  painter->drawText(head, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter) | Qt::TextSingleLine,
                    picture_.name);
}

}  // namespace tendon::gui
