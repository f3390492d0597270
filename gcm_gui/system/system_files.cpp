#include <gcm_gui/system/system_files.h>

#include <gcm_gui/commands/commands.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/session/link_state.h>
#include <gcm_gui/system/diff_panel.h>
#include <gcm_gui/views/tab_panel.h>

#include <QAction>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenu>

namespace tendon::gui {
namespace {

constexpr auto kSuffix = ".gcm.json";

QString NameOfDemo() { return Words::tr("the demo"); }

}  // namespace

SystemFiles::SystemFiles(const WindowParts& parts, TabPanel& centre, QWidget& window)
    : QObject(&window),
      link_(parts.link),
      window_(window),
      centre_(centre),
      document_(parts.store, parts.reports),
      restore_(document_, parts.plans, parts.reports),
      plans_done_(restore_, document_, parts.activity),
      panel_(new DiffPanel(document_, restore_, parts.read_only)),
      page_(centre.addPage(panel_, Words::tr("Diff"))),
      demo_(parts.demo) {
  connect(&document_, &SystemDocument::notice, this, &SystemFiles::notice);
  connect(&document_, &SystemDocument::changed, this, &SystemFiles::titleChanged);
  connect(&document_, &SystemDocument::opened, this, &SystemFiles::showTab);
  connect(&document_, &SystemDocument::changed, this, &SystemFiles::previewBringUp);
  connect(&document_, &SystemDocument::notice, this, [this] { brings_up_ = false; });
  connect(&restore_, &PlanController::changed, this, [this] {
    if (!isBringUpInSight()) brings_up_ = false;
    if (starts_demo_) showDemo();
  });
}

void SystemFiles::addCommands(Commands& commands) {
  const auto add = [&](const QString& text, const QKeySequence& key, auto what) {
    commands.add(Commands::Menu::kSystem, text, key, what);
  };
  QMenu& menu = commands.menu(Commands::Menu::kSystem);
  add(Words::tr("&Open a system file…"), QKeySequence::Open, [this] { open(); });
  add(Words::tr("&Import a cisst file…"), {}, [this] { importFile(); });
  add(Words::tr("Sa&ve the running system"), QKeySequence::Save, [this] { save(); });
  add(Words::tr("Save the running system &as…"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S),
      [this] { saveAs(); });
  add(Words::tr("&Restore the system file…"), {}, [this] { restoreAll(); });
  QMenu* states = menu.addMenu(Words::tr("&Go back to a state"));
  states->setObjectName(QStringLiteral("states"));
  connect(states, &QMenu::aboutToShow, this, [this, states] { fillStates(*states); });
  menu.addSeparator();
}

void SystemFiles::bringUp(const QString& path) {
  brings_up_ = true;
  document_.open(path);
}

/// Makes the plan again whenever a process joins, until the user executes or dismisses the plan.
void SystemFiles::previewBringUp() {
  if (brings_up_ && link_.state() == LinkState::State::kConnected) panel_->previewAll();
}

bool SystemFiles::isBringUpInSight() const {
  const PlanController::Phase phase = restore_.phase();
  const bool is_plan =
      phase == PlanController::Phase::kAsking || phase == PlanController::Phase::kPreview;
  return is_plan && restore_.goal() == document_.name();
}

void SystemFiles::startDemo() {
  document_.read(demo_, [this](const Result<SystemFile>& demo) {
    if (demo) return carryOutDemo(*demo);
    Q_EMIT notice(Words::tr("The system file of the demo cannot be read: ") +
                  ToQString(demo.error().message));
  });
}

void SystemFiles::carryOutDemo(SystemFile demo) {
  if (restore_.phase() == PlanController::Phase::kRunning) {
    showTab();
    return Q_EMIT notice(Words::tr("A plan is running; the demo starts after the plan"));
  }
  for (auto& process : demo.processes) {
    if (!process.start) process.start = SystemFile::Start{};
  }
  brings_up_ = false;
  starts_demo_ = true;
  restore_.preview(demo, NameOfDemo());
}

/// Executes the plan of the demo as soon as it is ready, unless another plan has replaced it.
void SystemFiles::carryOutDemoPlan() {
  const Plan& plan = restore_.plan();
  if (!plan.steps.empty()) return restore_.execute(AfterError::kStop);
  starts_demo_ = false;
  if (!plan.obstacles.empty()) {
    showTab();
    return Q_EMIT notice(Words::tr("The demo was not started: ") +
                         ToQString(plan.obstacles.front()));
  }
  restore_.leave();
  Q_EMIT notice(Words::tr("The demo is already running"));
}

void SystemFiles::showDemo() {
  const bool is_asking = restore_.phase() == PlanController::Phase::kAsking;
  starts_demo_ = restore_.goal() == NameOfDemo();
  if (!starts_demo_ || is_asking) return;
  if (restore_.phase() == PlanController::Phase::kPreview) return carryOutDemoPlan();
  if (restore_.phase() == PlanController::Phase::kRunning) {
    return Q_EMIT notice(Words::tr("Starting the demo: step %1 of %2")
                             .arg(restore_.outcomes().size() + 1)
                             .arg(restore_.plan().steps.size()));
  }
  starts_demo_ = false;
  if (restore_.phase() != PlanController::Phase::kDone) return;
  if (const auto& error = restore_.outcome().error) {
    showTab();  // this tab shows the failed step and the steps before it
    return Q_EMIT notice(Words::tr("The demo was not started: ") + ToQString(error->message));
  }
  Q_EMIT notice(Words::tr("The demo runs: click a hollow port, then a port that lights up"));
}

void SystemFiles::showTab() { centre_.setCurrent(page_); }

QFileDialog* SystemFiles::makeDialog(const QString& title) {
  auto* dialog = new QFileDialog(&window_, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setNameFilter(Words::tr("System files (*%1)").arg(QString::fromLatin1(kSuffix)));
  return dialog;
}

void SystemFiles::open() {
  QFileDialog* dialog = makeDialog(Words::tr("Open a system file"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, &document_, &SystemDocument::open);
  dialog->open();
}

void SystemFiles::importFile() {
  auto* dialog = new QFileDialog(&window_, Words::tr("Import a cisst file"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setNameFilter(Words::tr("Files of a cisst component manager (*.json)"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &SystemFiles::askForProcess);
  dialog->open();
}

/// Asks for the name of the process, because the imported file describes one process without a
/// name.
void SystemFiles::askForProcess(const QString& file) {
  QStringList names;
  for (const auto& [name, entry] : document_.catalogue().processes()) {
    names.append(ToQString(name));
  }
  auto* dialog = new QInputDialog(&window_);
  dialog->setObjectName(QStringLiteral("importProcess"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("Import a cisst file"));
  dialog->setLabelText(Words::tr("The process to which the components belong"));
  dialog->setComboBoxItems(names);
  dialog->setComboBoxEditable(true);
  dialog->setTextValue(names.isEmpty() ? QFileInfo(file).baseName() : names.front());
  connect(dialog, &QInputDialog::textValueSelected, this,
          [this, file](const QString& process) { document_.importFrom(file, process); });
  dialog->open();
}

void SystemFiles::save() {
  if (!document_.isOpen()) return saveAs();
  document_.save(document_.path());
}

void SystemFiles::saveAs() {
  QFileDialog* dialog = makeDialog(Words::tr("Save the running system"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QString::fromLatin1(kSuffix).mid(1));
  dialog->selectFile(document_.isOpen() ? document_.path() : QStringLiteral("system.gcm.json"));
  connect(dialog, &QFileDialog::fileSelected, &document_, &SystemDocument::save);
  dialog->open();
}

void SystemFiles::restoreAll() {
  if (!document_.isOpen()) {
    return Q_EMIT notice(Words::tr("Open a system file first: Ctrl+O"));
  }
  showTab();
  panel_->previewAll();
}

void SystemFiles::fillStates(QMenu& menu) {
  menu.clear();
  const auto& all = document_.snapshots().all();
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    const QString goal = Words::tr("State at ") + ClockText(it->when).left(8);
    menu.addAction(goal, this, [this, goal, system = it->system] {
      showTab();
      restore_.preview(system, goal.toLower());
    });
  }
  if (menu.isEmpty()) menu.addAction(Words::tr("Nothing has changed yet"))->setEnabled(false);
}

}  // namespace tendon::gui
