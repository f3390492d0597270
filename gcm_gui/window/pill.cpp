#include <gcm_gui/window/pill.h>

#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QFontMetrics>
#include <QPainter>
#include <algorithm>

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

/// Returns the dim words that fit in this width. Drops whole parts, such as " · 3 components", if
/// possible.
QString Pill::shortened(int width) const {
  const QFontMetrics metrics(Theme::instance().text());
  const QString separator = QStringLiteral(" · ");
  QString text = dim_;
  while (metrics.horizontalAdvance(text) > width && text.contains(separator)) {
    text = text.section(separator, 0, -2);
  }
  // elidedText() would also shorten a text whose advance was rounded down.
  if (metrics.horizontalAdvance(text) <= width) return text;
  return metrics.elidedText(text, Qt::ElideRight, width);
}

void Pill::paintEvent(QPaintEvent*) {
  const Theme& theme = Theme::instance();
  const QString dim = shortened(width() - sizeWith({}).width() - kPillSpace);
  const QRectF body(0, 0, std::min(width(), sizeWith(dim).width()), height());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(hasFocus() ? QPen(theme.color(Token::kAccent)) : QPen(Qt::NoPen));
  painter.setBrush(theme.color(underMouse() && isEnabled() && receivers(SIGNAL(clicked(bool))) > 0
                                   ? Token::kLine
                                   : Token::kRaised));
  painter.drawRoundedRect(body.adjusted(0.5, 0.5, -0.5, -0.5), kRadius, kRadius);
  PaintMark(painter, QRectF(kPillInset, 0, kMark, height()), mark_);
  QRect room = rect().adjusted(kPillInset + kMark + kPillSpace / 2, 0, -kPillInset, 0);
  painter.setFont(theme.strong());
  painter.setPen(theme.color(Token::kText));
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, strong_);
  room.setLeft(room.left() + QFontMetrics(theme.strong()).horizontalAdvance(strong_) + kPillSpace);
  painter.setFont(theme.text());
  painter.setPen(theme.color(Token::kDim));
  painter.drawText(room, Qt::AlignVCenter | Qt::AlignLeft, dim);
}

}  // namespace tendon::gui
