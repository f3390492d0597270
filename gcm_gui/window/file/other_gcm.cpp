#include <gcm_gui/language/words.h>
#include <gcm_gui/window/file/other_gcm.h>

#include <QCoreApplication>
#include <QInputDialog>
#include <QProcess>
#include <QWidget>
#include <utility>

namespace tendon::gui {

QStringList ArgumentsFor(const QStringList& mine, const QString& address) {
  const QStringList places{QStringLiteral("--gcm"), QStringLiteral("--listen")};
  QStringList arguments;
  for (qsizetype i = 0; i < mine.size(); ++i) {
    if (places.contains(mine[i])) {
      ++i;  // its value
    } else if (!places.contains(mine[i].section('=', 0, 0))) {
      arguments.append(mine[i]);
    }
  }
  return arguments << QStringLiteral("--gcm") << address;
}

OtherGcm::OtherGcm(QWidget& window, Launch launch)
    : QObject(&window), window_(window), launch_(std::move(launch)) {}

bool OtherGcm::startProgram(const QStringList& arguments) {
  return QProcess::startDetached(QCoreApplication::applicationFilePath(), arguments);
}

void OtherGcm::ask() {
  auto* dialog = new QInputDialog(&window_);
  dialog->setObjectName(QStringLiteral("otherGcm"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("Connect to another machine"));
  dialog->setLabelText(Words::tr("Address of its GCM, as robot1 or robot1:10705"));
  connect(dialog, &QInputDialog::textValueSelected, this, &OtherGcm::goTo);
  dialog->open();
}

void OtherGcm::goTo(const QString& address) {
  const QString wanted = address.trimmed();
  if (wanted.isEmpty()) return;
  const QStringList mine = QCoreApplication::arguments().mid(1);
  if (launch_(ArgumentsFor(mine, wanted))) {
    window_.close();
  } else {
    Q_EMIT notice(Words::tr("Another window could not be started"));
  }
}

}  // namespace tendon::gui
