#include <gcm_gui/replay/recording_opener.h>

#include <gcm_gui/language/words.h>
#include <tendon/base/os/termination.h>

#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QProcess>
#include <QUrl>
#include <utility>

namespace tendon::gui {

RecordingOpener::RecordingOpener(QStringList program, const QString& folder, QWidget& window)
    : QObject(&window), program_(std::move(program)), notes_(folder), window_(window) {}

void RecordingOpener::ask() {
  QFileDialog& dialog = ShowRecordingDialog(window_, notes_, Words::tr("Open a recording"),
                                            QStringLiteral("openRecording"));
  connect(&dialog, &QFileDialog::fileSelected, this, &RecordingOpener::open);
}

void RecordingOpener::open(const QString& file) {
  if (program_.isEmpty()) return;
  // The other window is ended by signals, although this program holds them.
  const os::TerminationUnblockScope unblocked;
  const QString path = QFileInfo(file).absoluteFilePath();
  if (!QProcess::startDetached(program_.front(), program_.mid(1) + QStringList{path})) {
    return Q_EMIT notice(Words::tr("%1 cannot be opened, because %2 cannot be started")
                             .arg(QFileInfo(file).fileName(), program_.front()));
  }
  notes_.addRecent(path);
  Q_EMIT notice(Words::tr("%1 opens in a separate window").arg(QFileInfo(file).fileName()));
}

QStringList RecordingOpener::recordingsIn(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls()) {
    if (url.isLocalFile() && url.path().endsWith(QStringLiteral(".mcap"), Qt::CaseInsensitive)) {
      files << url.toLocalFile();
    }
  }
  return files;
}

QFileDialog& ShowRecordingDialog(QWidget& window, const RecordingNotes& notes, const QString& title,
                                 const QString& name) {
  auto* dialog = new QFileDialog(&window, title);
  dialog->setObjectName(name);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  dialog->setNameFilters({Words::tr("Recordings (*.mcap)"), Words::tr("All files (*)")});
  const QStringList recent = notes.recent();
  if (!recent.isEmpty()) dialog->setDirectory(QFileInfo(recent.front()).path());
  dialog->open();
  return *dialog;
}

}  // namespace tendon::gui
