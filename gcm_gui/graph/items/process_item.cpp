#include <gcm_gui/graph/items/process_item.h>

#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetricsF>
#include <QPainter>
#include <QStyleOptionGraphicsItem>
#include <algorithm>
#include <tuple>

namespace tendon::gui {

namespace {

// The title at a small scale, in pixels.
constexpr double kFarTitle = 20;
constexpr double kMinFarTitle = 64;

}  // namespace

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
  const QString title = name_ + QStringLiteral(" · ") + WordOf(state_);
  return IsGone(state_) ? title + ' ' + AgeText(now_ - since_) : title;
}

QRectF ProcessItem::boundingRect() const { return QRectF({}, size_).adjusted(-1, -1, 1, 1); }

QColor ProcessItem::titleColor() const {
  return Theme::instance().color(state_ == ProcessState::kSuspect ? Token::kWarning : Token::kDim);
}

void ProcessItem::paintFarTitle(QPainter& painter, double scale) const {
  const Theme& theme = Theme::instance();
  const QFontMetricsF metrics(theme.strong());
  painter.save();
  painter.translate(pos());
  painter.scale(1 / scale, 1 / scale);
  const double most = std::max(size_.width() * scale, kMinFarTitle);
  const QString text = metrics.elidedText(title(), Qt::ElideRight, most - kNodeInset);
  const QRectF plate(0, 0, metrics.horizontalAdvance(text) + kNodeInset, kFarTitle);
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme.color(Token::kPanel, 0.85));
  painter.drawRoundedRect(plate, 4, 4);
  painter.setFont(theme.strong());
  painter.setPen(titleColor());
  painter.drawText(plate, Qt::AlignCenter, text);
  painter.restore();
}

void ProcessItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget* viewport) {
  ExceptionGuard::run(viewport, ViewWork::kDrawing, [&] { draw(painter); });
}

void ProcessItem::draw(QPainter* painter) {
  const Theme& theme = Theme::instance();
  const bool gone = IsGone(state_);
  painter->setRenderHint(QPainter::Antialiasing);
  QPen pen(theme.color(selected_ ? Token::kAccent : Token::kLine), selected_ ? 1.5 : 1);
  if (gone) pen.setDashPattern({4, 4});
  painter->setPen(pen);
  painter->setBrush(theme.color(Token::kPanel, gone ? 0.5 : 1.0));
  painter->drawRoundedRect(QRectF({}, size_).adjusted(0.5, 0.5, -0.5, -0.5), kRadius + 2,
                           kRadius + 2);
  const double scale =
      QStyleOptionGraphicsItem::levelOfDetailFromTransform(painter->worldTransform());
  if (scale < kFarAway) return;  // then paintFarTitle() draws the title
  painter->setFont(theme.strong());
  painter->setPen(titleColor());
  const QRectF head(kNodeInset, 3, size_.width() - 2 * kNodeInset, 22);
  painter->drawText(head, static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter) | Qt::TextSingleLine,
                    title());
  if (!empty_) return;
  painter->setFont(theme.text());
  painter->setPen(theme.color(Token::kDim));
  painter->drawText(head.translated(0, 26), static_cast<int>(Qt::AlignLeft | Qt::AlignVCenter),
                    Words::tr("no components"));
}

}  // namespace tendon::gui
