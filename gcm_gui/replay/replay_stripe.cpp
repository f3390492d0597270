#include <gcm_gui/replay/replay_stripe.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QPainter>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr int kHeight = 28;

}  // namespace

ReplayStripe::ReplayStripe(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("replayStripe"));
  setFixedHeight(kHeight);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ReplayStripe::show(const QString& file, const QString& about, const QString& time) {
  file_ = file;
  about_ = about;
  time_ = time;
  setAccessibleName(text());
  update();
}

QString ReplayStripe::text() const {
  return QStringList{Words::tr("REPLAY"), file_, about_, time_}.join(' ').trimmed();
}

QSize ReplayStripe::minimumSizeHint() const { return {2 * kInset, kHeight}; }

void ReplayStripe::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const Theme& theme = Theme::instance();
  painter.fillRect(rect(), theme.color(Token::kWarning));
  painter.setPen(theme.color(Token::kOnAccent));
  QRect free = rect().adjusted(kInset, 0, -kInset, 0);
  // Draws a text at the left or right end of `free`, and removes the used part from `free`.
  const auto draw = [&](const QFont& font, const QString& text, Qt::Alignment side,
                        Qt::TextElideMode elide) {
    if (text.isEmpty() || free.width() <= 0) return;
    painter.setFont(font);
    const QFontMetrics metrics(font);
    const QString shown = metrics.elidedText(text, elide, free.width());
    painter.drawText(free, static_cast<int>(side | Qt::AlignVCenter), shown);
    const int width = metrics.horizontalAdvance(shown) + kInset;
    side == Qt::AlignLeft ? free.setLeft(free.left() + width) : free.setRight(free.right() - width);
  };
  QFont word = theme.strong();
  word.setLetterSpacing(QFont::AbsoluteSpacing, 2);
  word.setBold(true);
  draw(word, Words::tr("REPLAY"), Qt::AlignLeft, Qt::ElideNone);
  draw(theme.mono(), time_, Qt::AlignRight, Qt::ElideLeft);
  draw(theme.strong(), file_, Qt::AlignLeft, Qt::ElideMiddle);
  draw(theme.text(), about_, Qt::AlignLeft, Qt::ElideRight);
}

}  // namespace tendon::gui
