#include <gcm_gui/inspector/event_list.h>

#include <gcm_gui/activity/events_page.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tool_row.h>

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kCountPeriod{500};

}  // namespace

EventList::EventList(SystemReports& reports, QWidget* parent)
    : QWidget(parent), reports_(reports), rate_(MakeNote(QStringLiteral("inspector.eventRate"))) {
  RowView* list = MakeRowList(events_, QStringLiteral("inspector.events"), Words::tr("Events"),
                              Words::tr("No event has been raised since this list was opened."));
  list->rows().setAllLeft(true);
  QToolButton* clear = MakeLinkButton(Words::tr("Clear"), QStringLiteral("inspector.clearEvents"));
  connect(clear, &QToolButton::clicked, &events_, &EventsModel::clear);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(MakeToolRow({rate_}, {clear}));
  column->addWidget(list, 1);
  connect(&reports, &SystemReports::eventsArrived, &events_, Guarded(&events_, &EventsModel::add));
  connect(&reports, &SystemReports::eventsLost, &events_, Guarded(&events_, &EventsModel::addLost));
  connect(&rate_timer_, &QTimer::timeout, this, Guarded(this, &EventList::showRate));
  rate_timer_.setInterval(kCountPeriod);
  connect(&events_, &QAbstractItemModel::rowsInserted, this, &EventList::showRate);
  connect(&events_, &QAbstractItemModel::rowsRemoved, this, &EventList::showRate);
  connect(&events_, &QAbstractItemModel::modelReset, this, &EventList::showRate);
}

void EventList::show(const QString& component) {
  component_ = component;
  events_.setPart(component.isEmpty() ? QStringLiteral("/") : component);
  listen();
}

void EventList::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rate_timer_.start();
  listen();
  showRate();
}

void EventList::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  rate_timer_.stop();
  reports_.listen(this, {});
}

void EventList::listen() {
  const bool is_wanted = isVisible() && !component_.isEmpty();
  reports_.listen(this,
                  is_wanted ? QStringList{component_ + QStringLiteral("/**")} : QStringList());
}

void EventList::showRate() { rate_->setText(CountsText(events_)); }

}  // namespace tendon::gui
