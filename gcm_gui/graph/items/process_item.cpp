#include <gcm_gui/graph/items/process_item.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/models/state_of.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <tuple>

namespace tendon::gui {

ProcessItem::ProcessItem() { setZValue(0); }

void ProcessItem::show(const ProcessPicture& picture, const QRectF& rect) {
  const bool empty = picture.nodes.empty();
  auto shown = std::tie(name_, state_, since_, empty_, size_);
  const QSizeF size = rect.size();
  if (shown == std::tie(picture.name, picture.state, picture.since, empty, size) &&
      pos() == rect.topLeft()) {
    return;
  }
  prepareGeometryChange();
  shown = std::tie(picture.name, picture.state, picture.since, empty, size);
  setPos(rect.topLeft());
  update();
}

void ProcessItem::setNow(std::int64_t now) {
  now_ = now;
  if (IsGone(state_)) update();
}

void ProcessItem::setSelected(bool selected) {
  if (selected == selected_) return;
  selected_ = selected;
  update();
}

QString ProcessItem::title() const {
  if (state_ == ProcessState::kAlive) return name_;
  const QString word = ToQString(ToString(state_));
  const QString title = name_ + QStringLiteral(" · ") + word;
  return IsGone(state_) ? title + ' ' + AgeText(now_ - since_) : title;
}

QRectF ProcessItem::boundingRect() const { return QRectF({}, size_).adjusted(-1, -1, 1, 1); }

void ProcessItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const Theme& theme = Theme::instance();
  const bool gone = IsGone(state_);
  painter->setRenderHint(QPainter::Antialiasing);
  QPen pen(theme.color(selected_ ? Token::kAccent : Token::kLine), selected_ ? 1.5 : 1);
  if (gone) pen.setDashPattern({4, 4});
  painter->setPen(pen);
  painter->setBrush(theme.color(Token::kPanel, gone ? 0.5 : 1.0));
  painter->drawRoundedRect(QRectF({}, size_).adjusted(0.5, 0.5, -0.5, -0.5), kRadius + 2,
                           kRadius + 2);
  painter->setFont(theme.strong());
  const bool suspect = state_ == ProcessState::kSuspect;
  painter->setPen(theme.color(suspect ? Token::kWarning : Token::kDim));
  const QRectF head(kNodeInset, 3, size_.width() - 2 * kNodeInset, 22);
  painter->drawText(head, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter) | Qt::TextSingleLine,
                    title());
  if (!empty_) return;
  painter->setFont(theme.text());
  painter->setPen(theme.color(Token::kDim));
  painter->drawText(head.translated(0, 26), static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter),
                    QStringLiteral("no components"));
}

}  // namespace tendon::gui
