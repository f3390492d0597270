#include <gcm_gui/views/overlay_card.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/theme/header_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>

#include <QAbstractButton>
#include <QCheckBox>
#include <QKeyEvent>
#include <QLayout>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr int kWidestCard = 760;
constexpr int kCardMargin = 12;

bool IsOwnKey(int key) {
  return key == Qt::Key_Escape || key == Qt::Key_Space || key == Qt::Key_Return ||
         key == Qt::Key_Enter;
}

}  // namespace

OverlayCard::OverlayCard(QWidget& place, QWidget* body)
    : QFrame(place.window()),
      place_(place),
      body_(body),
      head_(new HeaderRow),
      leave_(new QToolButton),
      scroll_(new QScrollArea) {
  setProperty("role", QStringLiteral("card"));
  ExceptionGuard::setName(*this, {});
  setFocusPolicy(Qt::StrongFocus);
  setAutoFillBackground(true);
  leave_->setObjectName(QStringLiteral("closeCard"));
  leave_->setAccessibleName(Words::tr("Close"));
  leave_->setToolTip(Words::tr("Close  (Esc)"));
  leave_->setText(QStringLiteral("✕"));
  leave_->setFocusPolicy(Qt::StrongFocus);
  SetRole(*leave_, QStringLiteral("dim"));
  connect(leave_, &QToolButton::clicked, this, &OverlayCard::close);
  body->setProperty("role", QStringLiteral("cardBody"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidget(body);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 1);
  column->setSpacing(0);
  column->addWidget(head_);
  column->addWidget(scroll_, 1);
  body->installEventFilter(this);
  place.installEventFilter(this);
  hide();
}

void OverlayCard::addToHead(QWidget* widget) {
  head_->addRight(widget);
  head_->addRight(leave_);
  setTabOrder(widget, leave_);
}

void OverlayCard::open() {
  if (isHidden()) before_ = window()->focusWidget();
  show();
  fit();
  raise();
  if (!isAncestorOf(window()->focusWidget())) setFocus(Qt::ShortcutFocusReason);
}

void OverlayCard::close() {
  if (isHidden()) return;
  const bool had_focus = window()->focusWidget() == this || isAncestorOf(window()->focusWidget());
  hide();
  if (had_focus && before_ != nullptr) before_->setFocus(Qt::OtherFocusReason);
  Q_EMIT closed();
}

void OverlayCard::fit() {
  if (isHidden()) return;
  const QRect room =
      QRect(place_.mapTo(window(), QPoint()), place_.size())
          .adjusted(kCardMargin, kHeadHeight + kCardMargin, -kCardMargin, -kCardMargin);
  const int width = std::min(kWidestCard, room.width());
  QLayout& lines = *body_->layout();
  lines.activate();
  const int wanted = kHeadHeight + 4 + lines.totalHeightForWidth(width - 2);
  const int height = std::min(wanted, room.height());
  // The card is at the bottom, so that as much of the graph as possible stays visible.
  setGeometry(room.center().x() - width / 2, room.bottom() + 1 - height, width, height);
}

bool OverlayCard::eventFilter(QObject* watched, QEvent* event) {
  const bool moves = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  if (watched == &place_ && moves) fit();
  if (watched == body_ && event->type() == QEvent::LayoutRequest) fit();
  return QFrame::eventFilter(watched, event);
}

bool OverlayCard::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      IsOwnKey(static_cast<QKeyEvent*>(event)->key())) {
    // The card handles the key, so no shortcut of the window may be triggered.
    event->accept();
    return true;
  }
  return QFrame::event(event);
}

void OverlayCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return close();
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    auto* button = qobject_cast<QAbstractButton*>(window()->focusWidget());
    const bool is_pressed = button != nullptr && qobject_cast<QCheckBox*>(button) == nullptr;
    return is_pressed ? button->click() : enter();
  }
  QFrame::keyPressEvent(event);
}

}  // namespace tendon::gui
