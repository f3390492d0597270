#include <gcm_gui/models/text.h>
#include <gcm_gui/session/gcm_link.h>
#include <gcm_gui/system/diff_panel.h>
#include <gcm_gui/views/tab_panel.h>
#include <gcm_gui/window/commands/commands.h>
#include <gcm_gui/window/file/system_files.h>

#include <QAction>
#include <QFileDialog>
#include <QMenu>

namespace tendon::gui {
namespace {

constexpr auto kSuffix = ".gcm.json";

}  // namespace

SystemFiles::SystemFiles(const WindowParts& parts, TabPanel& centre, QWidget& window)
    : QObject(&window),
      link_(parts.link),
      window_(window),
      centre_(centre),
      document_(parts.store),
      restore_(document_, parts.plans),
      panel_(new DiffPanel(document_, restore_, parts.read_only)),
      page_(centre.addPage(panel_, QStringLiteral("Diff"))) {
  connect(&document_, &SystemDocument::told, this, &SystemFiles::notice);
  connect(&document_, &SystemDocument::changed, this, &SystemFiles::titleChanged);
  connect(&document_, &SystemDocument::opened, this, &SystemFiles::showTab);
  connect(&document_, &SystemDocument::changed, this, &SystemFiles::previewBringUp);
  connect(&document_, &SystemDocument::told, this, [this] { brings_up_ = false; });
  connect(&restore_, &Restore::changed, this, [this] {
    if (!is_previewing_) brings_up_ = false;
  });
}

void SystemFiles::addCommands(Commands& commands) {
  const auto add = [&](const char* text, const QKeySequence& key, auto what) {
    commands.add(Commands::Menu::kSystem, QString::fromUtf8(text), key, what);
  };
  QMenu& menu = commands.menu(Commands::Menu::kSystem);
  add("&Open a system file…", QKeySequence::Open, [this] { open(); });
  add("Sa&ve what runs", QKeySequence::Save, [this] { save(); });
  add("Save what runs &as…", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), [this] { saveAs(); });
  add("&Restore the system file…", {}, [this] { restoreAll(); });
  QMenu* states = menu.addMenu(QStringLiteral("&Go back to a state"));
  states->setObjectName(QStringLiteral("states"));
  connect(states, &QMenu::aboutToShow, this, [this, states] { fillStates(*states); });
  menu.addSeparator();
}

void SystemFiles::bringUp(const QString& path) {
  brings_up_ = true;
  document_.open(path);
}

/// Again whenever something joins, until the user takes it or leaves it.
void SystemFiles::previewBringUp() {
  if (!brings_up_ || link_.state() != GcmLink::State::kConnected) return;
  is_previewing_ = true;
  panel_->previewAll();
  is_previewing_ = false;
}

void SystemFiles::showTab() { centre_.setCurrent(page_); }

QFileDialog* SystemFiles::makeDialog(const QString& title) {
  auto* dialog = new QFileDialog(&window_, title);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setNameFilter(QStringLiteral("System files (*%1)").arg(QString::fromLatin1(kSuffix)));
  return dialog;
}

void SystemFiles::open() {
  QFileDialog* dialog = makeDialog(QStringLiteral("Open a system file"));
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, &document_, &SystemDocument::open);
  dialog->open();
}

void SystemFiles::save() {
  if (!document_.isOpen()) return saveAs();
  document_.save(document_.path());
}

void SystemFiles::saveAs() {
  QFileDialog* dialog = makeDialog(QStringLiteral("Save what runs"));
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QString::fromLatin1(kSuffix).mid(1));
  dialog->selectFile(document_.isOpen() ? document_.path() : QStringLiteral("system.gcm.json"));
  connect(dialog, &QFileDialog::fileSelected, &document_, &SystemDocument::save);
  dialog->open();
}

void SystemFiles::restoreAll() {
  if (!document_.isOpen()) {
    return Q_EMIT notice(QStringLiteral("Open a system file first: Ctrl+O"));
  }
  showTab();
  panel_->previewAll();
}

void SystemFiles::fillStates(QMenu& menu) {
  menu.clear();
  const auto& all = document_.snapshots().all();
  for (auto it = all.rbegin(); it != all.rend(); ++it) {
    const QString goal = QStringLiteral("State at ") + ClockText(it->when).left(8);
    menu.addAction(goal, this, [this, goal, system = it->system] {
      showTab();
      restore_.preview(system, goal.toLower());
    });
  }
  if (menu.isEmpty()) menu.addAction(QStringLiteral("Nothing has changed yet"))->setEnabled(false);
}

}  // namespace tendon::gui
