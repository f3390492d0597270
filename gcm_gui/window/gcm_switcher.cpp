#include <gcm_gui/window/gcm_switcher.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/session/link_state.h>

#include <QCoreApplication>
#include <QInputDialog>
#include <QProcess>
#include <QWidget>
#include <utility>

namespace tendon::gui {

QStringList ArgumentsFor(const QStringList& mine, const QString& address) {
  const QStringList own{QStringLiteral("--gcm"), QStringLiteral("--listen"),
                        QStringLiteral("--describe-ui")};
  const QStringList without_value{QStringLiteral("--read-only"), QStringLiteral("--no-tour"),
                                  QStringLiteral("--insecure")};
  QStringList arguments;
  for (qsizetype i = 0; i < mine.size() && mine[i] != QStringLiteral("--"); ++i) {
    if (!mine[i].startsWith(QStringLiteral("--"))) continue;  // skips the system file
    const bool is_kept = !own.contains(mine[i].section('=', 0, 0));
    if (is_kept) arguments.append(mine[i]);
    if (mine[i].contains('=') || without_value.contains(mine[i])) continue;
    if (++i < mine.size() && is_kept) arguments.append(mine[i]);
  }
  return arguments << QStringLiteral("--gcm") << address;
}

GcmSwitcher::GcmSwitcher(QWidget& window, const LinkState& link, Launch launch)
    : QObject(&window), window_(window), link_(link), launch_(std::move(launch)) {}

bool GcmSwitcher::startProgram(const QStringList& arguments) {
  return QProcess::startDetached(QCoreApplication::applicationFilePath(), arguments);
}

void GcmSwitcher::ask() {
  auto* dialog = new QInputDialog(&window_);
  dialog->setObjectName(QStringLiteral("otherGcm"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(Words::tr("Connect to another machine"));
  dialog->setLabelText(
      Words::tr("Address of the GCM on that machine, such as robot1 or robot1:10705"));
  connect(dialog, &QInputDialog::textValueSelected, this, &GcmSwitcher::goTo);
  dialog->open();
}

void GcmSwitcher::goTo(const QString& address) {
  const QString wanted = address.trimmed();
  if (wanted.isEmpty()) return;
  const QStringList mine = QCoreApplication::arguments().mid(1);
  if (!launch_(ArgumentsFor(mine, wanted))) {
    return Q_EMIT notice(
        Words::tr("Another window could not be started; type in a terminal: gcm-gui --gcm %1")
            .arg(wanted));
  }
  if (!link_.isHosted()) {
    window_.close();
    return;
  }
  Q_EMIT notice(
      Words::tr("%1 is shown in another window; this window stays open, because it hosts a GCM")
          .arg(wanted));
}

}  // namespace tendon::gui
