#include <gcm_gui/activity/activity_strip.h>

#include <gcm_gui/activity/events_page.h>
#include <gcm_gui/activity/log_page.h>
#include <gcm_gui/console/console_page.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/link_button.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPersistentModelIndex>
#include <QTabBar>
#include <QToolButton>

namespace tendon::gui {
namespace {

constexpr int kLinksWidth = 200;

}  // namespace

ActivityStrip::ActivityStrip(const WindowParts& parts, ProblemsModel& problems,
                             Selection& selection, QWidget* parent)
    : TabPanel(QStringLiteral("strip"), parent),
      activity_(parts.activity),
      actions_(parts.actions) {
  ActivityModel& activity = activity_;
  list_ = MakeRowList(activity, QStringLiteral("activity"), Words::tr("Activity"),
                      Words::tr("Your changes to the system are listed here."));
  list_->rows().setAllLeft(true);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->header()->setSectionResizeMode(ActivityModel::kLinks, QHeaderView::Fixed);
  list_->header()->resizeSection(ActivityModel::kLinks, kLinksWidth);
  RowView* problem_list = MakeRowList(problems, QStringLiteral("problems"), Words::tr("Problems"),
                                      Words::tr("Nothing is wrong."));
  problem_list->rows().setAllLeft(true);
  addPage(list_, Words::tr("Activity"));
  problems_page_ = addPage(problem_list, Words::tr("Problems"));
  addReports(parts, selection);

  connect(&activity, &QAbstractItemModel::rowsInserted, this,
          [this](const QModelIndex&, int first, int last) { linkRows(first, last); });
  connect(&activity, &QAbstractItemModel::dataChanged, this,
          [this](const QModelIndex& first, const QModelIndex& last) {
            linkRows(first.row(), last.row());
          });
  connect(&problems, &ProblemsModel::countChanged, this, &ActivityStrip::showProblemCount);
  const auto select = [&selection](const QModelIndex& index) {
    selection.select(index.siblingAtColumn(0).data(kPathRole).toString());
  };
  connect(list_, &QTreeView::clicked, this, select);
  const auto choose = [this](const QModelIndex& index) {
    Q_EMIT problemChosen(index.data(kPathRole).toString());
  };
  connect(problem_list, &QTreeView::clicked, this, choose);
  connect(problem_list, &QTreeView::activated, this, choose);
  linkRows(0, activity.rowCount() - 1);
  showProblemCount(problems.rowCount());
}

void ActivityStrip::addReports(const WindowParts& parts, Selection& selection) {
  auto* log = new LogPage(parts.reports, parts.store, parts.actions);
  auto* events = new EventsPage(parts.reports, selection);
  const int log_page = addPage(log, Words::tr("Log"));
  addPage(events, Words::tr("Events"));
  connect(log, &LogPage::pathChosen, &selection, &Selection::select);
  connect(events, &EventsPage::pathChosen, this, &ActivityStrip::jumpRequested);
  if (parts.replay != nullptr) return setCurrent(log_page);  // nothing is done to a recording
  const QString history =
      parts.kept.isEmpty() ? QString() : parts.kept + QStringLiteral("/console");
  console_ = new ConsolePage(parts.console, history);
  console_page_ = addPage(console_, Words::tr("Console"));
  connect(console_, &ConsolePage::notice, this, &ActivityStrip::notice);
  connect(&tabs(), &QTabBar::tabBarClicked, this, [this](int page) {
    if (page == console_page_) showConsole();
  });
}

void ActivityStrip::showConsole() {
  setCurrent(console_page_);
  console_->focusLine();
}

void ActivityStrip::linkRows(int first, int last) {
  for (int row = first; row <= last; ++row) linkRow(row);
}

void ActivityStrip::linkRow(int row) {
  const QModelIndex index = activity_.index(row, ActivityModel::kLinks);
  auto* cell = new QWidget;
  auto* line = new QHBoxLayout(cell);
  line->setContentsMargins(0, 0, kInset - 6, 0);
  line->setSpacing(0);
  line->addStretch();
  if (activity_.canUndo(row)) {
    QToolButton* undo = MakeLinkButton(Words::tr("Undo"), QStringLiteral("undo"));
    undo->setProperty("changesSystem", true);
    connect(undo, &QToolButton::clicked, this, [this] { actions_.undo(); });
    line->addWidget(undo);
  }
  if (const QString command = activity_.command(row); !command.isEmpty()) {
    QToolButton* copy = MakeLinkButton(Words::tr("Copy as command"), QStringLiteral("copyCommand"));
    copy->setToolTip(command);
    connect(copy, &QToolButton::clicked, this,
            [command] { QGuiApplication::clipboard()->setText(command); });
    line->addWidget(copy);
  }
  list_->setIndexWidget(index, cell);
}

void ActivityStrip::showProblemCount(int count) {
  setTitle(problems_page_,
           count == 0 ? Words::tr("Problems") : Words::tr("Problems %1").arg(count));
  tabs().setTabTextColor(problems_page_,
                         count == 0 ? QColor() : Theme::instance().color(Token::kWarning));
}

}  // namespace tendon::gui
