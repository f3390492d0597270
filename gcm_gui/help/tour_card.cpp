#include <gcm_gui/help/tour_card.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>

namespace tendon::gui {
namespace {

constexpr int kWidth = 344;
constexpr int kAway = kInset;

QRect MovedInto(QRect card, const QRect& room) {
  card.moveLeft(std::max(room.left(), std::min(card.left(), room.right() + 1 - card.width())));
  card.moveTop(std::max(room.top(), std::min(card.top(), room.bottom() + 1 - card.height())));
  return card;
}

}  // namespace

TourCard::TourCard(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel),
      text_(new QLabel),
      place_(new QLabel),
      skip_(addButton("tour.skip", Words::tr("Skip"))),
      back_(addButton("tour.back", Words::tr("Back"))),
      next_(addButton("tour.next", Words::tr("Next"))) {
  setObjectName(QStringLiteral("tour.card"));
  setProperty("role", QStringLiteral("card"));
  setAutoFillBackground(true);
  title_->setObjectName(QStringLiteral("tour.title"));
  title_->setWordWrap(true);
  SetRole(*title_, QStringLiteral("strong"));
  text_->setObjectName(QStringLiteral("tour.text"));
  text_->setTextFormat(Qt::PlainText);
  text_->setWordWrap(true);
  place_->setObjectName(QStringLiteral("tour.place"));
  SetRole(*place_, QStringLiteral("dim"));
  SetRole(*next_, QStringLiteral("primary"));
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(2 * kGrid);
  buttons->addWidget(place_);
  buttons->addStretch();
  buttons->addWidget(skip_);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kInset + kGrid, kInset, kInset + kGrid, kInset);
  column->setSpacing(2 * kGrid);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addSpacing(kGrid);
  column->addLayout(buttons);
  connect(skip_, &QPushButton::clicked, this, &TourCard::endRequested);
  connect(back_, &QPushButton::clicked, this, &TourCard::backRequested);
  connect(next_, &QPushButton::clicked, this, &TourCard::nextRequested);
}

QPushButton* TourCard::addButton(const char* name, const QString& text) {
  auto* button = new QPushButton(text, this);
  button->setObjectName(QString::fromLatin1(name));
  button->installEventFilter(this);
  return button;
}

void TourCard::show(const QString& title, const QString& text, int number, int count) {
  title_->setText(title);
  text_->setText(text);
  place_->setText(Words::tr("%1 of %2").arg(number).arg(count));
  if (number == 1 && back_->hasFocus()) takeFocus();
  back_->setEnabled(number > 1);
  skip_->setVisible(number < count);
  next_->setText(number < count ? Words::tr("Next") : Words::tr("Done"));
  setAccessibleName(Words::tr("Tour, %1: %2").arg(place_->text(), title));
  setAccessibleDescription(text);
  QFrame::show();
  // Tells a screen reader that the text has changed, although the focus stays.
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

QSize TourCard::wantedSize() const {
  layout()->activate();
  return {kWidth, layout()->totalHeightForWidth(kWidth)};
}

void TourCard::takeFocus() { next_->setFocus(Qt::ShortcutFocusReason); }

bool TourCard::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto modifiers = static_cast<QKeyEvent*>(event)->modifiers();
    if ((modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0) {
      event->accept();
      return true;
    }
  }
  return QFrame::event(event);
}

bool TourCard::eventFilter(QObject* watched, QEvent* event) {
  auto* button = qobject_cast<QPushButton*>(watched);
  if (event->type() == QEvent::KeyPress && button != nullptr) {
    return press(static_cast<QKeyEvent*>(event)->key(), *button);
  }
  return QFrame::eventFilter(watched, event);
}

bool TourCard::press(int key, QPushButton& focused) {
  switch (key) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
      focused.click();
      return true;
    case Qt::Key_Right:
      Q_EMIT nextRequested();
      return true;
    case Qt::Key_Left:
      if (back_->isEnabled()) Q_EMIT backRequested();
      return true;
    case Qt::Key_Escape:
      Q_EMIT endRequested();
      return true;
    default:
      return false;
  }
}

bool TourCard::focusNextPrevChild(bool next) {
  QList<QPushButton*> way;
  for (QPushButton* button : {next_, skip_, back_}) {
    if (button->isVisible() && button->isEnabled()) way.append(button);
  }
  if (way.isEmpty()) return true;
  auto at = way.size();
  for (qsizetype i = 0; i < way.size(); ++i) {
    if (way[i]->hasFocus()) at = i;
  }
  const qsizetype step = next ? 1 : way.size() - 1;
  way[(at + step) % way.size()]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  return true;
}

QRect CardBeside(const QRect& shown, const QSize& card, const QRect& room) {
  QRect centred({}, card);
  centred.moveCenter(shown.center());
  const int right = shown.right() + 1 + kAway;
  const int left = shown.left() - kAway - card.width();
  const int below = shown.bottom() + 1 + kAway;
  const int above = shown.top() - kAway - card.height();
  const std::array places{QPoint(right, centred.top()), QPoint(left, centred.top()),
                          QPoint(centred.left(), below), QPoint(centred.left(), above)};
  for (const QPoint& place : places) {
    const QRect moved = MovedInto({place, card}, room);
    if (room.contains(moved) && !moved.intersects(shown)) return moved;
  }
  centred.moveBottom(shown.bottom() - kAway);
  return MovedInto(centred, room);
}

}  // namespace tendon::gui
