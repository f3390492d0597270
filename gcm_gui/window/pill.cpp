#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/pill.h>

#include <QFontMetrics>
#include <QPainter>

namespace tendon::gui {
namespace {

constexpr int kPillInset = 8;
constexpr int kMark = 16;
constexpr int kPillSpace = 6;
constexpr int kHeight = 26;

}  // namespace

Pill::Pill(QWidget* parent) : QAbstractButton(parent) {
  setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
  setFocusPolicy(Qt::TabFocus);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Pill::show(StateMark mark, const QString& strong, const QString& dim) {
  if (mark == mark_ && strong == strong_ && dim == dim_) return;
  mark_ = mark;
  strong_ = strong;
  dim_ = dim;
  setAccessibleName(spoken());
  updateGeometry();
  update();
}

QSize Pill::sizeHint() const { return sizeWith(dim_); }

QSize Pill::sizeWith(const QString& dim) const {
  const QFontMetrics strong(Theme::instance().strong());
  const QFontMetrics text(Theme::instance().text());
  int width = 2 * kPillInset + kMark;
  if (!strong_.isEmpty()) width += kPillSpace / 2 + strong.horizontalAdvance(strong_);
  if (!dim.isEmpty()) width += kPillSpace + text.horizontalAdvance(dim);
  return {width + 2, kHeight};
}

void Pill::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(hasFocus() ? QPen(theme.color(Token::kAccent)) : QPen(Qt::NoPen));
  painter.setBrush(theme.color(underMouse() && isEnabled() && receivers(SIGNAL(clicked(bool))) > 0
                                   ? Token::kLine
                                   : Token::kRaised));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
  PaintMark(painter, QRectF(kPillInset, 0, kMark, height()), mark_);
  QRect room = rect().adjusted(kPillInset + kMark + kPillSpace / 2, 0, -kPillInset, 0);
  painter.setFont(theme.strong());
  painter.setPen(theme.color(Token::kText));
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, strong_);
  room.setLeft(room.left() + QFontMetrics(theme.strong()).horizontalAdvance(strong_) + kPillSpace);
  painter.setFont(theme.text());
  painter.setPen(theme.color(Token::kDim));
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft,
                   QFontMetrics(theme.text()).elidedText(dim_, Qt::ElideRight, room.width()));
}

}  // namespace tendon::gui
