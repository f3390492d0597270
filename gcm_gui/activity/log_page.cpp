#include <gcm_gui/activity/log_page.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tool_row.h>

#include <QAbstractScrollArea>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QToolButton>
#include <memory>

namespace tendon::gui {
namespace {

/// When contents are added at the end, scrolls to them, unless the user has scrolled up.
void FollowEnd(QAbstractScrollArea& view) {
  QScrollBar* bar = view.verticalScrollBar();
  const auto is_at_end = std::make_shared<bool>(true);
  QObject::connect(bar, &QScrollBar::valueChanged, bar,
                   [bar, is_at_end](int value) { *is_at_end = value >= bar->maximum(); });
  QObject::connect(bar, &QScrollBar::rangeChanged, bar, [bar, is_at_end](int, int maximum) {
    if (*is_at_end) bar->setValue(maximum);
  });
}

}  // namespace

LogPage::LogPage(SystemReports& reports, const CatalogueStore& store, SystemActions& actions,
                 QWidget* parent)
    : QWidget(parent), reports_(reports), store_(store), actions_(actions), filter_(log_) {
  setObjectName(QStringLiteral("logPage"));
  list_ = MakeRowList(filter_, QStringLiteral("log"), Words::tr("Log"),
                      Words::tr("The log of all processes is listed here."));
  FollowEnd(*list_);
  FillPage(*this, buildBar(), list_);
  const auto choose = [this](const QModelIndex& index) {
    Q_EMIT pathChosen(index.data(kPathRole).toString());
  };
  connect(list_, &QTreeView::activated, this, choose);
  connect(list_, &QTreeView::clicked, this, choose);
  connect(&reports, &SystemReports::beganAgain, &log_, Guarded(&log_, &LogModel::clear));
  connect(&reports, &SystemReports::logArrived, &log_, Guarded(&log_, &LogModel::add));
  for (const auto signal : {&QAbstractItemModel::rowsInserted, &QAbstractItemModel::rowsRemoved}) {
    connect(&filter_, signal, this, &LogPage::showCount);
  }
  connect(&filter_, &QAbstractItemModel::modelReset, this, &LogPage::showCount);
  showCount();
}

QWidget* LogPage::buildBar() {
  level_ = new QComboBox;
  level_->setObjectName(QStringLiteral("log.level"));
  level_->setAccessibleName(Words::tr("Lowest level that is shown"));
  for (const QString& text : {Words::tr("All levels"), Words::tr("Info and above"),
                              Words::tr("Warnings and errors"), Words::tr("Errors")}) {
    level_->addItem(text);
  }
  connect(level_, &QComboBox::currentIndexChanged, this,
          [this](int index) { filter_.setLevel(static_cast<LogLevel>(index)); });
  words_ = new QLineEdit;
  words_->setObjectName(QStringLiteral("log.filter"));
  words_->setAccessibleName(Words::tr("Filter the log"));
  words_->setPlaceholderText(Words::tr("Filter: words, from:robot/arm, -word"));
  words_->setClearButtonEnabled(true);
  connect(words_, &QLineEdit::textChanged, &filter_, &LogFilter::setText);
  count_ = MakeNote(QStringLiteral("log.count"));
  QToolButton* levels = MakeLinkButton(Words::tr("Set level…"), QStringLiteral("log.setLevel"));
  levels->setProperty("changesSystem", true);
  levels->setToolTip(
      Words::tr("Sets the lowest level that a process logs; this lasts until the process ends"));
  levels->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(levels);
  menu->setObjectName(QStringLiteral("log.levels"));
  connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillLevels(*menu); });
  levels->setMenu(menu);
  QToolButton* clear = MakeLinkButton(Words::tr("Clear"), QStringLiteral("log.clear"));
  clear->setToolTip(Words::tr("Clears this list; the processes and the GCM keep their records"));
  connect(clear, &QToolButton::clicked, &log_, &LogModel::clear);
  return MakeToolRow({level_, words_}, {count_, levels, clear});
}

void LogPage::fillLevels(QMenu& menu) {
  menu.clear();
  for (const auto& [name, entry] : store_.catalogue().processes()) {
    if (entry.process.state == ProcessState::kLost) continue;
    QMenu* levels = menu.addMenu(ToQString(name));
    for (const auto& one : kPayload<LogLevel>.enumerators) {
      levels->addAction(
          ToQString(one.name) + Words::tr(" and above"),
          [this, process = name, level = one.value] { actions_.setLogLevel(process, level); });
    }
  }
  if (menu.isEmpty()) menu.addAction(Words::tr("There is no process"))->setEnabled(false);
}

void LogPage::focusFilter() { words_->setFocus(); }

void LogPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  if (!std::exchange(is_watching_, true)) reports_.watchLog();
}

void LogPage::showCount() {
  const int shown = filter_.rowCount();
  const int all = log_.rowCount();
  QString text = shown == all ? CountText(all, Words::tr("%1 record"), Words::tr("%1 records"))
                              : Words::tr("%1 of %2").arg(shown).arg(all);
  if (log_.lost() > 0) text += Words::tr(" · %1 lost").arg(log_.lost());
  count_->setText(text);
  list_->setEmptyText(all == 0 ? Words::tr("The log of all processes is listed here.")
                               : Words::tr("No record matches the filter."));
}

}  // namespace tendon::gui
