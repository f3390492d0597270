#include <gcm_gui/window/gcm_launcher.h>

#include <gcm_gui/language/words.h>

#include <QProcess>
#include <utility>

namespace tendon::gui {

GcmLauncher::GcmLauncher(QStringList command, const LinkState& link, QObject* parent)
    : QObject(parent), command_(std::move(command)), link_(link) {}

void GcmLauncher::start() {
  const QString& program = command_.front();
  const QStringList words = command_.mid(1) + QStringList{QStringLiteral("--gcm"), link_.address(),
                                                          QStringLiteral("serve")};
  const bool is_started = QProcess::startDetached(program, words);
  Q_EMIT notice(
      is_started ? Words::tr("Starting a GCM; it keeps running when this window is closed")
                 : Words::tr("%1 could not be started: check that it is installed").arg(program));
}

}  // namespace tendon::gui
