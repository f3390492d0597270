#include <gcm_gui/recording/window_recording.h>

#include <gcm_gui/commands/commands.h>
#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/recording/record_button.h>
#include <gcm_gui/recording/recording_strip.h>
#include <tendon/base/os/termination.h>

#include <QAction>
#include <QActionGroup>
#include <QClipboard>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QUrl>
#include <utility>

namespace tendon::gui {

WindowRecording::WindowRecording(RecordingRunner& runner, ActivityModel& activity,
                                 RecordingController::Sources sources, QWidget& window)
    : QObject(&window),
      window_(window),
      controller_(runner, activity, std::move(sources)),
      menu_(new QMenu(&window)),
      button_(new RecordButton(controller_, *menu_)),
      strip_(new RecordingStrip(controller_)) {
  menu_->setObjectName(QStringLiteral("recordChoices"));
  connect(&controller_, &RecordingController::notice, this, &WindowRecording::notice);
  connect(&controller_, &RecordingController::changed, this,
          Guarded(this, &WindowRecording::refresh));
  connect(strip_, &RecordingStrip::showInFolderRequested, this, &WindowRecording::showInFolder);
  connect(strip_, &RecordingStrip::copyPathRequested, this, &WindowRecording::copyPath);
  connect(strip_, &RecordingStrip::folderRequested, this, &WindowRecording::askForFolder);
}

void WindowRecording::addCommands(Commands& commands) {
  toggle_ = &commands.add(Commands::Menu::kRecord, Words::tr("&Start recording"),
                          QKeySequence(Qt::CTRL | Qt::Key_R), [this] { controller_.toggle(); });
  save_last_ = &commands.add(Commands::Menu::kRecord, Words::tr("Save the &last 30 s"),
                             QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_R),
                             [this] { controller_.saveLast(); });
  commands.menu(Commands::Menu::kRecord).addSeparator();
  addScopes(commands);
  commands.menu(Commands::Menu::kRecord).addSeparator();
  QAction& folder = commands.add(Commands::Menu::kRecord, Words::tr("&Folder for recordings…"), {},
                                 [this] { askForFolder(); });
  menu_->addAction(save_last_);
  menu_->addSeparator();
  menu_->addActions(scopes_);
  menu_->addSeparator();
  menu_->addAction(&folder);
  refresh();
}

void WindowRecording::addScopes(Commands& commands) {
  auto* group = new QActionGroup(this);
  const auto add = [&](const QString& text, RecordingScope scope) {
    QAction& action =
        commands.add(Commands::Menu::kRecord, text, {}, [this, scope] { choose(scope); });
    action.setCheckable(true);
    group->addAction(&action);
    scopes_ << &action;
  };
  add(Words::tr("What to record: &plotted signals"), RecordingScope::kPlotted);
  add(Words::tr("What to record: selected &component"), RecordingScope::kSelected);
  add(Words::tr("What to record: &everything"), RecordingScope::kEverything);
}

void WindowRecording::choose(RecordingScope scope) {
  controller_.setScope(scope);
  if (controller_.report() && controller_.report()->kind == RecordingReport::Kind::kNothingChosen) {
    controller_.dismissReport();  // it asked for this choice
  }
}

void WindowRecording::refresh() {
  if (toggle_ == nullptr) return;
  const bool is_idle = controller_.state() == RecordingController::State::kIdle;
  toggle_->setText(is_idle ? Words::tr("&Start recording") : Words::tr("&Stop recording"));
  scopes_[static_cast<qsizetype>(controller_.scope())]->setChecked(true);
  save_last_->setEnabled(is_idle);
  for (QAction* scope : scopes_) scope->setEnabled(is_idle);
}

void WindowRecording::askForFolder() {
  auto* dialog = new QFileDialog(&window_, Words::tr("Folder for recordings"));
  dialog->setObjectName(QStringLiteral("recordingFolder"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly);
  dialog->setDirectory(controller_.folder());
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& folder) {
    controller_.setFolder(folder);
    controller_.dismissReport();
    Q_EMIT notice(Words::tr("Recordings go to %1").arg(controller_.folder()));
  });
  dialog->open();
}

void WindowRecording::showInFolder(const QString& file) {
  const QString folder = QFileInfo(file).path();
  // Signals end the file manager, too, although this program holds them.
  const os::TerminationUnblockScope unblocked;
  if (QDesktopServices::openUrl(QUrl::fromLocalFile(folder))) return;
  Q_EMIT notice(Words::tr("No file manager could be started; the file is in %1").arg(folder));
}

void WindowRecording::copyPath(const QString& file) {
  QGuiApplication::clipboard()->setText(file);
  Q_EMIT notice(Words::tr("The path is in the clipboard"));
}

}  // namespace tendon::gui
