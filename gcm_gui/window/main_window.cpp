#include <gcm_gui/window/main_window.h>

#include <gcm_gui/activity/activity_strip.h>
#include <gcm_gui/call/favourite_bar.h>
#include <gcm_gui/commands/graph_commands.h>
#include <gcm_gui/commands/window_commands.h>
#include <gcm_gui/connect/candidate_panel.h>
#include <gcm_gui/connect/match_card.h>
#include <gcm_gui/diagnosis/diagnosis_binding.h>
#include <gcm_gui/diagnosis/diagnosis_card.h>
#include <gcm_gui/graph/edge_health.h>
#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/graph_scene.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/graph/zoom_buttons.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/help/tour.h>
#include <gcm_gui/inspector/inspector.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/recording/record_button.h>
#include <gcm_gui/recording/recording_strip.h>
#include <gcm_gui/recording/window_recording.h>
#include <gcm_gui/replay/recording_opener.h>
#include <gcm_gui/replay/recording_overlay.h>
#include <gcm_gui/replay/replay_page.h>
#include <gcm_gui/replay/replay_session.h>
#include <gcm_gui/replay/replay_strip.h>
#include <gcm_gui/replay/window_replay.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/theme/icon.h>
#include <gcm_gui/theme/metrics.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/views/catalogue_panel.h>
#include <gcm_gui/views/catalogue_tree.h>
#include <gcm_gui/views/row_delegate.h>
#include <gcm_gui/views/row_view.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/empty_state.h>
#include <gcm_gui/window/gcm_launcher.h>
#include <gcm_gui/window/gcm_switcher.h>
#include <gcm_gui/window/lost_banner.h>
#include <gcm_gui/window/mark_binding.h>
#include <gcm_gui/window/notice_line.h>
#include <gcm_gui/window/plot_binding.h>
#include <gcm_gui/window/top_bar.h>
#include <tendon/base/log.h>
#include <tendon/base/path.h>

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr QSize kWindow{1280, 800};
constexpr int kCatalogueWidth = 280;
constexpr int kInspectorWidth = 336;
constexpr int kStripHeight = 124;
constexpr int kMinCatalogueWidth = 208;
constexpr int kMinCentreWidth = 480;
// Wide enough for a form, so that the panel need not become wider.
constexpr int kMinInspectorWidth = 334;
constexpr int kMinStripHeight = 80;
constexpr int kRoomToRead = 220;  // pixels; enough to read a log or a console
constexpr int kPlotsHeight = 268;
constexpr int kMinPlotsHeight = 120;
constexpr std::chrono::seconds kSecond{1};

}  // namespace

MainWindow::MainWindow(WindowParts parts)
    : parts_(parts),
      filter_(catalogue_model_),
      mode_(parts.store, parts.actions),
      favourites_(parts.kept.isEmpty() ? QString()
                                       : parts.kept + QStringLiteral("/favourites.json")) {
  setObjectName(QStringLiteral("window"));
  setWindowIcon(ThemeIcon(QStringLiteral("logo"), Token::kAccent));
  resize(kWindow);
  setAcceptDrops(true);
  opener_ = new RecordingOpener(parts_.viewer, parts_.kept, *this);
  connectModels();
  connectExceptionGuard();
  buildViews();
  connectViews();
  commands_ = new WindowCommands(*this);
  second_.start(kSecond);
  connect(&second_, &QTimer::timeout, this, Guarded(this, &MainWindow::tick));
  tick();
  showPage();
  showLink();
  catalogue_->tree().setFocus();
}

MainWindow::~MainWindow() = default;

Tour& MainWindow::tour() const { return commands_->tour(); }

void MainWindow::connectModels() {
  CatalogueStore& store = parts_.store;
  connect(&store, &CatalogueStore::changed, &catalogue_model_,
          Guarded(&catalogue_model_, &CatalogueModel::update));
  connect(&store, &CatalogueStore::changed, &connections_,
          Guarded(&connections_, &ConnectionsModel::update));
  connect(&store, &CatalogueStore::changed, &problems_,
          Guarded(&problems_, &ProblemsModel::update));
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &MainWindow::showPage));
  connect(&parts_.source, &SignalSource::valuesArrived, &catalogue_model_,
          Guarded(&catalogue_model_, &CatalogueModel::showValues));
  connect(&parts_.activity, &ActivityModel::finished, &problems_,
          Guarded(&problems_, &ProblemsModel::onActionFinished));
  ChangedParts all;
  for (const auto& [name, entry] : store.catalogue().processes()) all.insert({name, {}});
  catalogue_model_.update(store.catalogue(), all);
  connections_.update(store.catalogue());
  problems_.update(store.catalogue());
}

void MainWindow::connectExceptionGuard() {
  ExceptionGuard::setName(catalogue_model_, Words::tr("Catalogue"));
  ExceptionGuard::setName(filter_, Words::tr("Catalogue"));
  ExceptionGuard::setName(connections_, Words::tr("Connections"));
  ExceptionGuard::setName(problems_, Words::tr("Problems"));
  ExceptionGuard& guard = ExceptionGuard::instance();
  connect(&guard, &ExceptionGuard::changed, &problems_,
          [this, &guard] { problems_.showFaults(guard.faults()); });
  connect(&guard, &ExceptionGuard::faultReported, this, [this](const ViewFault& fault) {
    Log(LogLevel::kError, "gcm-gui",
        QStringLiteral("%1: %2 (%3 times)")
            .arg(fault.view, fault.what)
            .arg(fault.count)
            .toStdString());
    // An uncovered fault is only listed in Problems: the present notice about the user's action may
    // be more useful.
    if (!fault.is_covered) return;
    notice_->showNotice(Words::tr("%1 had an error: see Problems").arg(fault.view));
  });
}

void MainWindow::buildViews() {
  catalogue_ = new CataloguePanel(filter_, selection_, parts_.source);
  ExceptionGuard::setName(*catalogue_, Words::tr("Catalogue"));
  strip_ = new ActivityStrip(parts_, problems_, selection_);
  setMenuWidget(buildTop());
  QSplitter* centre = buildCentre();
  setCentralWidget(centre);
  buildPanels(*centre);
  addFavourites();
  // The order is from left to right: the catalogue comes before the middle.
  setTabOrder(&top_bar_->lastButton(), &catalogue_->filterField());
  setTabOrder(&catalogue_->filterField(), &catalogue_->tree());
  const auto apply_theme = [this] {
    QPalette colors = palette();
    colors.setColor(QPalette::Window, Theme::instance().color(Token::kCanvas));
    setPalette(colors);
  };
  apply_theme();
  connect(&Theme::instance(), &Theme::changed, this, apply_theme);
}

QWidget* MainWindow::buildTop() {
  top_bar_ = new TopBar(parts_.store, parts_.link);
  lost_ = new LostBanner(parts_.link);
  recording_ = new WindowRecording(parts_.recordings, parts_.activity,
                                   {.plotted = [this] { return plots_->paths(); },
                                    .selected = [this] { return selection_.paths(); }},
                                   *this);
  if (parts_.replay == nullptr) {
    top_bar_->addRecordButton(&recording_->button());
  } else {
    recording_->button().setParent(top_bar_);
    recording_->button().hide();
    replay_ = new WindowReplay(*parts_.replay, opener_->notes(), this);
  }
  auto* top = new QWidget;
  auto* column = new QVBoxLayout(top);
  column->setContentsMargins(0, 0, 0, kGap);
  column->setSpacing(kGap);
  column->addWidget(top_bar_);
  if (replay_ != nullptr) column->addWidget(&replay_->strip());
  column->addWidget(lost_);
  column->addWidget(&recording_->strip());
  return top;
}

QWidget* MainWindow::buildRight() {
  inspector_ = new Inspector(parts_.store, selection_, parts_.source, parts_.actions, parts_.calls,
                             parts_.reports);
  candidates_ = new CandidatePanel(mode_);
  right_ = new QStackedWidget;
  right_->addWidget(inspector_);
  right_->addWidget(candidates_);
  return right_;
}

void MainWindow::buildPanels(QSplitter& centre) {
  panels_ = new Panels(*this, centre);
  panels_->add(catalogue_, Words::tr("Catalogue"), Qt::LeftDockWidgetArea, kCatalogueWidth,
               kMinCatalogueWidth);
  panels_->add(buildRight(), Words::tr("Inspector"), Qt::RightDockWidgetArea, kInspectorWidth,
               kMinInspectorWidth);
  panels_->add(strip_, Words::tr("Activity"), Qt::BottomDockWidgetArea, kStripHeight,
               kMinStripHeight);
  connect(panels_, &Panels::shown, this, &MainWindow::showPerspective);
}

QSplitter* MainWindow::buildCentre() {
  centre_ = new TabPanel(QStringLiteral("centre"));
  centre_->addPage(buildGraphPage(), Words::tr("Graph"));
  centre_->addPage(buildConnectionsPage(), Words::tr("Connections"));
  files_ = new SystemFiles(parts_, *centre_, *this);
  notice_ = new NoticeLine(mode_, parts_.activity);
  centre_->addRight(notice_);
  plots_ = new PlotPanel;
  plots_->setAutoFillBackground(true);
  plots_->setMinimumHeight(kMinPlotsHeight);
  overlay_ = new RecordingOverlay(*plots_, opener_->notes(), *this);
  binding_ = new PlotBinding(*plots_, parts_.source, overlay_->source(), catalogue_model_, this);
  ExceptionGuard::setName(*plots_, Words::tr("Plots"));
  ExceptionGuard::setName(*binding_, Words::tr("Plots"));
  if (replay_ != nullptr) replay_->setPlots(*plots_);
  new MarkBinding(*plots_, parts_.store, parts_.activity, parts_.reports, plots_);
  auto* rows = new QSplitter(Qt::Vertical);
  rows->setObjectName(QStringLiteral("centreRows"));
  rows->setChildrenCollapsible(false);
  rows->setMinimumWidth(kMinCentreWidth);
  rows->setHandleWidth(kGap);
  rows->addWidget(centre_);
  rows->addWidget(plots_);
  rows->setStretchFactor(0, 1);
  rows->setSizes({kWindow.height() - kStripHeight - kTopBarHeight - kPlotsHeight, kPlotsHeight});
  return rows;
}

QWidget* MainWindow::buildGraphPage() {
  scene_ = new GraphScene(parts_.store, selection_, mode_, this);
  ExceptionGuard::setName(*scene_, Words::tr("Graph"));
  graph_ = new GraphView(*scene_, selection_, mode_);
  new ZoomButtons(*graph_);
  graph_commands_ = new GraphCommands(parts_, *graph_, *this);
  graph_page_ = new QStackedWidget;
  graph_page_->addWidget(buildEmptyPage());
  graph_page_->addWidget(graph_);
  return graph_page_;
}

QWidget* MainWindow::buildEmptyPage() {
  other_ = new GcmSwitcher(*this, parts_.link);
  gcm_start_ = new GcmLauncher(parts_.gcm, parts_.link, this);
  if (parts_.replay != nullptr) {
    auto* page = new ReplayPage(*parts_.replay);
    connect(page, &ReplayPage::openRequested, opener_, &RecordingOpener::ask);
    return page;
  }
  auto* empty = new EmptyState(parts_.link, {.gcm = !parts_.gcm.isEmpty(),
                                             .demo = !parts_.demo.isEmpty(),
                                             .recordings = opener_->isPossible(),
                                             .recent = opener_->notes().recent()});
  connect(empty, &EmptyState::otherRequested, other_, &GcmSwitcher::ask);
  connect(empty, &EmptyState::recordingRequested, opener_, &RecordingOpener::ask);
  connect(empty, &EmptyState::recentRequested, opener_, &RecordingOpener::open);
  connect(empty, &EmptyState::gcmRequested, gcm_start_, &GcmLauncher::start);
  connect(empty, &EmptyState::tourRequested, this, [this] { tour().start(); });
  connect(empty, &EmptyState::demoRequested, this, [this] { files_->startDemo(); });
  return empty;
}

QWidget* MainWindow::buildConnectionsPage() {
  RowView* list = MakeRowList(connections_, QStringLiteral("connections"), Words::tr("Connections"),
                              Words::tr("Nothing is connected."));
  list->rows().setAllLeft(true);
  list->rows().setLeftInset(2 * kGrid);
  list->setHeaderHidden(false);
  list->header()->setSectionResizeMode(QHeaderView::Stretch);
  connect(list, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (mode_.active()) return pickInConnectMode(index.data(kPathRole).toString());
    selection_.select(index.siblingAtColumn(0).data(kPathRole).toString());
  });
  connect(list->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
          [this, list](const QModelIndex& index) {
            if (!list->hasFocus() || mode_.active()) return;
            selection_.select(index.siblingAtColumn(0).data(kPathRole).toString());
          });
  return list;
}

void MainWindow::addFavourites() {
  auto* bar = new FavouriteBar(favourites_, parts_.store, parts_.calls);
  addToolBar(Qt::TopToolBarArea, bar);
  connect(bar, &FavouriteBar::notice, notice_, &NoticeLine::showNotice);
  connect(&favourites_, &Favourites::notice, notice_, &NoticeLine::showNotice);
  connect(bar, &FavouriteBar::pathChosen, this, &MainWindow::goTo);
  connect(inspector_, &Inspector::favouriteRequested, &favourites_,
          [this](const QString& path, const QString& argument) {
            favourites_.add({path, argument});
          });
}

void MainWindow::connectViews() {
  connect(&catalogue_->tree(), &CatalogueTree::plotRequested, binding_, &PlotBinding::plot);
  connect(&catalogue_->tree(), &CatalogueTree::connectRequested, this,
          &MainWindow::startConnecting);
  connect(&catalogue_->tree(), &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (mode_.active()) pickInConnectMode(index.data(kPathRole).toString());
  });
  connect(&catalogue_->tree(), &QTreeView::activated, this,
          [this](const QModelIndex&) { inspector_->focusCall(); });
  connect(inspector_, &Inspector::plotRequested, binding_, &PlotBinding::plotSignal);
  connect(inspector_, &Inspector::connectRequested, this, &MainWindow::startConnecting);
  connect(inspector_, &Inspector::notice, notice_, &NoticeLine::showNotice);
  connect(binding_, &PlotBinding::notice, notice_, &NoticeLine::showNotice);
  connect(top_bar_, &TopBar::problemsRequested, this, [this] {
    panels_->reveal(*strip_);
    strip_->showProblems();
  });
  connect(strip_, &TabPanel::currentChanged, this,
          [this] { panels_->ensureSize(*strip_, kRoomToRead); });
  connect(strip_, &ActivityStrip::jumpRequested, this, &MainWindow::goTo);
  connect(strip_, &ActivityStrip::problemChosen, this, &MainWindow::goTo);
  connect(strip_, &ActivityStrip::notice, notice_, &NoticeLine::showNotice);
  connect(files_, &SystemFiles::notice, notice_, &NoticeLine::showNotice);
  graph_commands_->keepPlaces(parts_, files_->document());
  connect(graph_commands_, &GraphCommands::notice, notice_, &NoticeLine::showNotice);
  connect(files_, &SystemFiles::titleChanged, this, &MainWindow::showLink);
  connect(recording_, &WindowRecording::notice, notice_, &NoticeLine::showNotice);
  connect(opener_, &RecordingOpener::notice, notice_, &NoticeLine::showNotice);
  connect(overlay_, &RecordingOverlay::notice, notice_, &NoticeLine::showNotice);
  if (replay_ != nullptr) {
    connect(replay_, &WindowReplay::notice, notice_, &NoticeLine::showNotice);
    connect(parts_.replay, &ReplaySession::moved, this, [this] {
      if (parts_.replay->isSought()) tick();  // the shown ages belong to another moment
    });
  }
  connect(plots_, &PlotPanel::notice, notice_, &NoticeLine::showNotice);
  connect(top_bar_, &TopBar::pauseRequested, plots_, &PlotPanel::setPaused);
  connect(plots_, &PlotPanel::pausedChanged, top_bar_, &TopBar::showPaused);
  connect(&problems_, &ProblemsModel::countChanged, top_bar_, &TopBar::showProblemCount);
  top_bar_->showProblemCount(problems_.rowCount());
  connect(&parts_.link, &LinkState::changed, this, Guarded(this, &MainWindow::showLink));
  connectModeToViews();
  connectWhy();
}

void MainWindow::connectWhy() {
  why_card_ = new DiagnosisCard(*centralWidget());
  why_ = new DiagnosisBinding(*why_card_, parts_.store, parts_.checks, parts_.actions, this);
  connect(&parts_.activity, &ActivityModel::finished, &why_->refusals(),
          Guarded(&why_->refusals(), &RefusedConnections::onActionFinished));
  connect(
      &mode_, &ConnectMode::mismatchPicked, &parts_.activity,
      [&activity = parts_.activity](const message::ConnectionEnds& ends, const QString& reason) {
        activity.finish(activity.begin({.required = ends.required, .provided = ends.provided}), 0.0,
                        reason);
      });
  connect(&why_->refusals(), &RefusedConnections::changed, scene_,
          [this] { scene_->showRefused(why_->refusals().all()); });
  connect(graph_, &GraphView::whyRequested, why_, &DiagnosisBinding::open);
  connect(inspector_, &Inspector::whyRequested, why_, &DiagnosisBinding::open);
  connect(strip_, &ActivityStrip::problemChosen, why_, &DiagnosisBinding::openProblem);
  connect(why_, &DiagnosisBinding::notice, notice_, &NoticeLine::showNotice);
  match_ = new MatchCard(*centralWidget(), parts_.store, parts_.actions);
  auto* health = new EdgeHealth(
      parts_.reports, [this] { return graph_->visibleConnections(); }, this);
  connect(&scene_->hover(), &GraphHover::connectionPointed, health, &EdgeHealth::point);
  connect(health, &EdgeHealth::counted, &scene_->hover(), &GraphHover::showReadout);
  connect(health, &EdgeHealth::found, scene_, &GraphScene::showWarning);
  connect(graph_, &GraphView::visibilityChanged, health, &EdgeHealth::setLooking);
}

void MainWindow::connectModeToViews() {
  connect(&mode_, &ConnectMode::changed, this, [this] {
    if (!mode_.active() && candidates_->isAncestorOf(focusWidget())) graph_->setFocus();
    right_->setCurrentWidget(mode_.active() ? static_cast<QWidget*>(candidates_) : inspector_);
  });
  connect(candidates_, &CandidatePanel::pointed, scene_, &GraphScene::point);
  connect(scene_, &GraphScene::refusalPointed, candidates_, &CandidatePanel::showRefusal);
  connect(&mode_, &ConnectMode::picked, scene_, &GraphScene::showRequested);
  connect(&mode_, &ConnectMode::picked, this, [this](const InterfaceName& required) {
    selection_.select(ToQString(ToString(required)));
    graph_->setFocus();
  });
  connect(&parts_.activity, &ActivityModel::finished, scene_,
          [this](const Action& action) { scene_->forgetRequested(action.required); });
}

void MainWindow::plotSelection() {
  for (const QString& path : selection_.paths()) binding_->plot(path);
}

void MainWindow::startConnecting(const QString& path) {
  const auto name = ParseInterfaceName(path.section('.', 0, 0).toStdString());
  if (!name.ok()) return;
  const bool required = parts_.store.catalogue().FindRequired(*name) != nullptr;
  centre_->setCurrent(0);
  if (!mode_.start({required ? Side::kRequired : Side::kProvided, *name})) return;
  selection_.select(path);
  graph_->reveal(path);
  candidates_->focusFilter();
}

void MainWindow::pickInConnectMode(const QString& path) {
  const auto name = ParseInterfaceName(path.section('.', 0, 0).toStdString());
  if (!name.ok()) return;
  const bool to_provided = mode_.chosen().side == Side::kRequired;
  mode_.pick({to_provided ? Side::kProvided : Side::kRequired, *name});
}

std::vector<InterfaceName> MainWindow::selectedRequired() const {
  std::vector<InterfaceName> all;
  for (const QString& path : selection_.paths()) {
    const auto name = ParseInterfaceName(path.toStdString());
    if (name.ok() && parts_.store.catalogue().FindRequired(*name) != nullptr) all.push_back(*name);
  }
  return all;
}

void MainWindow::connectSelection() {
  if (const auto required = selectedRequired(); required.size() > 1) return match_->open(required);
  const auto path = ParsePath(selection_.current().toStdString());
  if (!path.ok()) return notice_->showNotice(Words::tr("Select an interface to connect it"));
  if (!path->interface.empty()) return startConnecting(selection_.current());
  const auto* component = parts_.store.catalogue().FindComponent(path->process, path->component);
  if (component != nullptr) {
    for (const auto& required : component->required) {
      const InterfaceName name{path->process, path->component, required.name};
      if (parts_.store.catalogue().FindConnection(name) != nullptr) continue;
      return startConnecting(ToQString(ToString(name)));
    }
  }
  notice_->showNotice(selection_.current() + Words::tr(" has no unconnected required interface"));
}

void MainWindow::disconnectSelection() {
  const QString interface = selection_.current().section('.', 0, 0);
  const auto name = ParseInterfaceName(interface.toStdString());
  if (name.ok() && parts_.store.catalogue().FindConnection(*name) != nullptr) {
    return parts_.actions.disconnectInterface(*name);
  }
  notice_->showNotice(Words::tr("Select a connected required interface to disconnect it"));
}

void MainWindow::callSelection() {
  panels_->reveal(*inspector_);
  if (!inspector_->focusCall()) {
    notice_->showNotice(Words::tr("Select a command of a provided interface to call it"));
  }
}

void MainWindow::goTo(const QString& path) {
  if (path.isEmpty()) return;  // the problem concerns the window itself
  selection_.select(path);
  revealSelection();
}

void MainWindow::revealSelection() {
  catalogue_->tree().reveal(selection_.current());
  graph_->reveal(selection_.current());
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const bool has_recording = !RecordingOpener::recordingsIn(*event->mimeData()).isEmpty();
  if (has_recording && opener_->isPossible()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QString& file : RecordingOpener::recordingsIn(*event->mimeData())) {
    opener_->open(file);
  }
  event->acceptProposedAction();
}

void MainWindow::escape() {
  if (graph_->cancelDrag() || graph_commands_->search().leave()) return;
  if (mode_.active()) return mode_.leave();
  if (why_card_->isVisible()) return why_card_->close();
  if (match_->isVisible()) return match_->close();
  if (!commands_->closeCard()) notice_->showNotice({});
}

void MainWindow::showPage() {
  const auto& processes = parts_.store.catalogue().processes();
  const bool any = std::any_of(processes.begin(), processes.end(),
                               [](const auto& entry) { return !entry.second.components.empty(); });
  graph_page_->setCurrentWidget(any || processes.size() > 1 ? static_cast<QWidget*>(graph_)
                                                            : graph_page_->widget(0));
}

void MainWindow::showLink() {
  // The title names the system, because several windows may be open.
  const LinkState& link = parts_.link;
  if (link.isFile()) return setWindowTitle(Words::tr("REPLAY %1 – gcm-gui").arg(link.address()));
  const QString file = files_->document().title();
  setWindowTitle((file.isEmpty() ? file : file + QStringLiteral(" – ")) +
                 (link.isHosted() ? Words::tr("Hosting the GCM at %1 – gcm-gui")
                                  : Words::tr("GCM at %1 – gcm-gui"))
                     .arg(link.address()));
  const bool outdated = parts_.link.state() == LinkState::State::kLost;
  if (!outdated && lost_since_ > 0) {
    notice_->showNotice(Words::tr("The GCM is back after ") + AgeText(WallClock() - lost_since_));
  }
  lost_since_ = outdated ? parts_.link.since() : 0;
  catalogue_model_.setOutdated(outdated);
  connections_.setOutdated(outdated);
  scene_->setOutdated(outdated);
  inspector_->setOutdated(outdated);
}

void MainWindow::showPerspective(Panels::Perspective perspective) {
  centre_->setCurrent(perspective == Panels::Perspective::kDiagnose ? 1 : 0);
  if (perspective == Panels::Perspective::kDiagnose) strip_->showProblems();
}

void MainWindow::tick() {
  const qint64 now = WallClock();
  const auto set_now = [now](auto& view) {
    ExceptionGuard::run(&view, ViewWork::kHandling, [&] { view.setNow(now); });
  };
  set_now(catalogue_model_);
  set_now(*catalogue_);
  set_now(*scene_);
  set_now(*top_bar_);
  set_now(*lost_);
  // Updates the list of faults, because old faults disappear after a while.
  ExceptionGuard::run(&problems_, ViewWork::kHandling,
                      [this] { problems_.showFaults(ExceptionGuard::instance().faults()); });
  ExceptionGuard::instance().reportCountedFaults();
}

}  // namespace tendon::gui
