#include <gcm_gui/models/text.h>
#include <gcm_gui/theme/head_row.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/why/step_list.h>
#include <gcm_gui/why/why_card.h>

#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace tendon::gui {
namespace {

constexpr int kWidest = 760;
constexpr int kMargin = 12;

QLabel* MakeLine(const QString& name, const QString& role) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  SetRole(*label, role);
  return label;
}

QString ShortName(const InterfaceName& name) {
  return ToQString(name.component + '/' + name.interface);
}

bool IsOwnKey(int key) {
  return key == Qt::Key_Escape || key == Qt::Key_Space || key == Qt::Key_Return ||
         key == Qt::Key_Enter;
}

}  // namespace

WhyCard::WhyCard(QWidget& place)
    : QFrame(place.window()),
      place_(place),
      title_(new QLabel),
      verdict_(MakeLine(QStringLiteral("why.verdict"), QStringLiteral("strong"))),
      history_(MakeLine(QStringLiteral("why.history"), QStringLiteral("dim"))),
      steps_(new StepList(signatures_)),
      leftovers_(MakeLine(QStringLiteral("why.leftovers"), {})),
      scroll_(new QScrollArea),
      retry_(new QPushButton(QStringLiteral("Retry"))),
      copy_(new QPushButton(QStringLiteral("Copy report"))),
      leave_(new QToolButton) {
  setObjectName(QStringLiteral("whyCard"));
  setAccessibleName(QStringLiteral("Why?"));
  setFocusPolicy(Qt::StrongFocus);
  setAutoFillBackground(true);
  auto* body = new QWidget;
  body->setObjectName(QStringLiteral("why.body"));
  auto* lines = new QVBoxLayout(body);
  lines->setContentsMargins(kInset, 2 * kGrid, kInset, 2 * kGrid);
  lines->setSpacing(2 * kGrid);
  for (QWidget* part : {static_cast<QWidget*>(verdict_), static_cast<QWidget*>(history_),
                        static_cast<QWidget*>(steps_), static_cast<QWidget*>(leftovers_)}) {
    lines->addWidget(part);
  }
  lines->addStretch();
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidget(body);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 1, 1, 1);
  column->setSpacing(0);
  column->addWidget(buildHead());
  column->addWidget(scroll_, 1);
  body->installEventFilter(this);
  place.installEventFilter(this);
  connect(steps_, &StepList::copied, this, &WhyCard::notice);
  hide();
}

QWidget* WhyCard::buildHead() {
  auto* head = new HeadRow;
  title_->setObjectName(QStringLiteral("why.title"));
  SetRole(*title_, QStringLiteral("strong"));
  head->addLeft(title_);
  retry_->setObjectName(QStringLiteral("why.retry"));
  retry_->setAccessibleName(QStringLiteral("Try the connection again"));
  copy_->setObjectName(QStringLiteral("why.copyReport"));
  copy_->setAccessibleName(QStringLiteral("Copy the report"));
  leave_->setObjectName(QStringLiteral("why.close"));
  leave_->setAccessibleName(QStringLiteral("Close"));
  leave_->setToolTip(QStringLiteral("Close  (Esc)"));
  leave_->setText(QStringLiteral("✕"));
  leave_->setFocusPolicy(Qt::StrongFocus);
  SetRole(*leave_, QStringLiteral("dim"));
  connect(retry_, &QPushButton::clicked, this, &WhyCard::retryRequested);
  connect(copy_, &QPushButton::clicked, this, &WhyCard::copyReport);
  connect(leave_, &QToolButton::clicked, this, &WhyCard::close);
  for (QWidget* button : {static_cast<QWidget*>(retry_), static_cast<QWidget*>(copy_),
                          static_cast<QWidget*>(leave_)}) {
    head->addRight(button);
  }
  return head;
}

void WhyCard::begin(const message::Wire& wire) {
  const bool other = wire != report_.diagnosis.wire;
  report_.diagnosis.wire = wire;
  title_->setText(ShortName(wire.required) + QStringLiteral(" → ") + ShortName(wire.provided));
  title_->setToolTip(ToQString(ToString(wire.required) + " → " + ToString(wire.provided)));
  setAccessibleName(QStringLiteral("Why? ") + title_->toolTip());
  if (other || isHidden()) {
    tell(QStringLiteral("checking …"));
    steps_->setComparable(false);
    steps_->show({});
  }
  open();
}

void WhyCard::show(const WhyReport& report, const RequiredDescription* required,
                   const ProvidedDescription* provided) {
  report_ = report;
  verdict_->setText(report.verdict());
  history_->setText(report.history());
  history_->setVisible(report.refusal.has_value());
  const bool comparable = required != nullptr && provided != nullptr;
  if (comparable) signatures_.show(*required, *provided);
  steps_->setComparable(comparable);
  steps_->show(report.diagnosis);
  steps_->orderTabs(*leave_);
  leftovers_->setText(report.leftovers.join('\n'));
  leftovers_->setVisible(!report.leftovers.isEmpty());
  const bool works = report.diagnosis.is_connected && !report.diagnosis.failure;
  retry_->setText(report.refusal || report.diagnosis.is_connected ? QStringLiteral("Retry")
                                                                  : QStringLiteral("Connect"));
  retry_->setVisible(!works);
  copy_->setEnabled(true);
  setAccessibleDescription(report.text());
  fit();
}

void WhyCard::tell(const QString& sentence) {
  verdict_->setText(sentence);
  history_->hide();
  leftovers_->hide();
  retry_->hide();
  copy_->setEnabled(false);
  fit();
}

void WhyCard::open() {
  if (isHidden()) before_ = window()->focusWidget();
  QFrame::show();
  fit();
  raise();
  if (!isAncestorOf(window()->focusWidget())) setFocus(Qt::ShortcutFocusReason);
}

void WhyCard::close() {
  if (isHidden()) return;
  const bool had_focus = window()->focusWidget() == this || isAncestorOf(window()->focusWidget());
  hide();
  if (had_focus && before_ != nullptr) before_->setFocus(Qt::OtherFocusReason);
  Q_EMIT closed();
}

void WhyCard::copyReport() {
  QGuiApplication::clipboard()->setText(report_.text());
  Q_EMIT notice(QStringLiteral("The report is in the clipboard"));
}

void WhyCard::fit() {
  if (isHidden()) return;
  const QRect room = QRect(place_.mapTo(window(), QPoint()), place_.size())
                         .adjusted(kMargin, kHeadHeight + kMargin, -kMargin, -kMargin);
  const int width = std::min(kWidest, room.width());
  QLayout& lines = *scroll_->widget()->layout();
  lines.activate();
  const int wanted = kHeadHeight + 4 + lines.totalHeightForWidth(width - 2);
  const int height = std::min(wanted, room.height());
  // From below: the graph and its edge are seen as long as there is room.
  setGeometry(room.center().x() - width / 2, room.bottom() + 1 - height, width, height);
}

bool WhyCard::eventFilter(QObject* watched, QEvent* event) {
  const bool moves = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  if (watched == &place_ && moves) fit();
  if (watched == scroll_->widget() && event->type() == QEvent::LayoutRequest) fit();
  return QFrame::eventFilter(watched, event);
}

bool WhyCard::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      IsOwnKey(static_cast<QKeyEvent*>(event)->key())) {
    event->accept();  // they mean something here before they mean anything to the window
    return true;
  }
  return QFrame::event(event);
}

void WhyCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return close();
  auto* button = qobject_cast<QAbstractButton*>(window()->focusWidget());
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && button != nullptr) return button->click();
  QFrame::keyPressEvent(event);
}

}  // namespace tendon::gui
