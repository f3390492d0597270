#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/state_label.h>

#include <QFontMetrics>
#include <QPainter>

namespace tendon::gui {
namespace {

constexpr int kMarkWidth = 16;
constexpr int kSpace = 2;

}  // namespace

StateLabel::StateLabel(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StateLabel::show(StateMark mark, const QString& text) {
  mark_ = mark;
  text_ = text.isEmpty() ? WordOf(mark) : text;
  setAccessibleName(text_);
  updateGeometry();
  update();
}

QSize StateLabel::sizeHint() const {
  const QFontMetrics metrics(Theme::instance().text());
  return {kMarkWidth + kSpace + metrics.horizontalAdvance(text_) + 1, kRowHeight};
}

void StateLabel::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  PaintMark(painter, QRectF(0, 0, kMarkWidth, height()), mark_);
  painter.setFont(Theme::instance().text());
  painter.setPen(Theme::instance().color(ColorOf(mark_)));
  painter.drawText(rect().adjusted(kMarkWidth + kSpace, 0, 0, 0), Qt::AlignVCenter, text_);
}

}  // namespace tendon::gui
