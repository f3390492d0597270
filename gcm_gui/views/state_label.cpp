#include <gcm_gui/views/state_label.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetrics>
#include <QPainter>

namespace tendon::gui {
namespace {

constexpr int kMarkWidth = 16;
constexpr int kMarkSpace = 2;

}  // namespace

StateLabel::StateLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StateLabel::show(StateMark mark, const QString& text) {
  const QString shown = text.isEmpty() ? WordOf(mark) : text;
  if (mark == mark_ && shown == text_) return;
  mark_ = mark;
  text_ = shown;
  setAccessibleName(text_);
  updateGeometry();
  update();
}

void StateLabel::setStale(bool stale) {
  stale_ = stale;
  update();
}

QSize StateLabel::sizeHint() const {
  const QFontMetrics metrics(Theme::instance().text());
  return {kMarkWidth + kMarkSpace + metrics.horizontalAdvance(text_) + 1, kRowHeight};
}

void StateLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setOpacity(stale_ ? kStaleMarkOpacity : 1.0);
  PaintMark(painter, QRectF(0, 0, kMarkWidth, height()), mark_);
  painter.setOpacity(1.0);
  painter.setFont(Theme::instance().text());
  painter.setPen(Theme::instance().color(stale_ ? Token::kDim : ColorOf(mark_)));
  painter.drawText(rect().adjusted(kMarkWidth + kMarkSpace, 0, 0, 0), Qt::AlignVCenter, text_);
}

}  // namespace tendon::gui
