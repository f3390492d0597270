#include <gcm_gui/activity/events_page.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tool_row.h>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kRatePeriod{500};
enum Whose { kAll, kSelected };

/// Returns the component of an event: "robot/arm" for "robot/arm/Control.MoveTo".
QString ComponentOf(const QString& path) { return path.section('/', 0, 1); }

}  // namespace

QString CountsText(const EventsModel& events) {
  QString text = CountText(events.rowCount(), Words::tr("%1 event"), Words::tr("%1 events"));
  if (text.isEmpty()) text = Words::tr("no event");
  const double rate = events.rate(WallClock());
  if (rate > 0) text += Words::tr(" · %1 a second").arg(rate, 0, 'f', rate < 10 ? 1 : 0);
  if (events.lost() > 0) text += Words::tr(" · %1 lost").arg(events.lost());
  if (events.isPaused()) text += Words::tr(" · %1 waiting").arg(events.waiting());
  return text;
}

EventsPage::EventsPage(SystemReports& reports, Selection& selection, QWidget* parent)
    : QWidget(parent), reports_(reports), selection_(selection) {
  setObjectName(QStringLiteral("eventsPage"));
  list_ = MakeRowList(events_, QStringLiteral("events"), Words::tr("Events"),
                      Words::tr("No event has been raised since this page was opened."));
  FillPage(*this, buildBar(), list_);
  const auto choose = [this](const QModelIndex& index) {
    Q_EMIT pathChosen(index.data(kPathRole).toString());
  };
  connect(list_, &QTreeView::activated, this, choose);
  connect(&reports, &SystemReports::eventsArrived, &events_, Guarded(&events_, &EventsModel::add));
  connect(&reports, &SystemReports::beganAgain, &events_,
          Guarded(&events_, &EventsModel::startOver));
  connect(&reports, &SystemReports::eventsLost, &events_, Guarded(&events_, &EventsModel::addLost));
  connect(&selection, &Selection::changed, this, Guarded(this, &EventsPage::listen));
  connect(&rate_timer_, &QTimer::timeout, this, Guarded(this, &EventsPage::showRate));
  rate_timer_.start(kRatePeriod);
}

QWidget* EventsPage::buildBar() {
  whose_ = new QComboBox;
  whose_->setObjectName(QStringLiteral("events.whose"));
  whose_->setAccessibleName(Words::tr("Source of the listed events"));
  whose_->addItem(Words::tr("All components"));
  whose_->addItem(Words::tr("Selected component"));
  connect(whose_, &QComboBox::currentIndexChanged, this, &EventsPage::listen);
  words_ = new QLineEdit;
  words_->setObjectName(QStringLiteral("events.filter"));
  words_->setAccessibleName(Words::tr("Filter the events"));
  words_->setPlaceholderText(Words::tr("Filter: words, from:robot/arm, -word"));
  words_->setClearButtonEnabled(true);
  connect(words_, &QLineEdit::textChanged, this,
          [this](const QString& text) { events_.setWords(text.split(' ', Qt::SkipEmptyParts)); });
  rate_ = MakeNote(QStringLiteral("events.rate"));
  pause_ = MakeLinkButton(Words::tr("Pause"), QStringLiteral("events.pause"));
  pause_->setCheckable(true);
  pause_->setToolTip(Words::tr("The list is paused; new events are shown when the pause ends"));
  connect(pause_, &QToolButton::toggled, this, [this](bool paused) {
    events_.setPaused(paused);
    showRate();
  });
  QToolButton* clear = MakeLinkButton(Words::tr("Clear"), QStringLiteral("events.clear"));
  connect(clear, &QToolButton::clicked, &events_, &EventsModel::clear);
  return MakeToolRow({whose_, words_}, {rate_, pause_, clear});
}

void EventsPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  is_listening_ = true;
  listen();
  showRate();
}

void EventsPage::listen() {
  if (!is_listening_) return;
  const QString part =
      whose_->currentIndex() == kSelected ? ComponentOf(selection_.current()) : QString();
  const bool is_nothing = whose_->currentIndex() == kSelected && part.isEmpty();
  events_.setPart(is_nothing ? QStringLiteral("/") : part);
  list_->setEmptyText(is_nothing
                          ? Words::tr("Select a component to see its events.")
                          : Words::tr("No event has been raised since this page was opened."));
  list_->viewport()->update();
  if (is_nothing) return reports_.listen(this, {});
  reports_.listen(this, {part.isEmpty() ? QStringLiteral("**") : part + QStringLiteral("/**")});
}

void EventsPage::showRate() { rate_->setText(CountsText(events_)); }

}  // namespace tendon::gui
