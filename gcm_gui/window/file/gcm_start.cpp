#include <gcm_gui/language/words.h>
#include <gcm_gui/window/file/gcm_start.h>

#include <QProcess>
#include <utility>

namespace tendon::gui {

GcmStart::GcmStart(QString program, const GcmLink& link, QObject* parent)
    : QObject(parent), program_(std::move(program)), link_(link) {}

void GcmStart::start() {
  const QStringList words{QStringLiteral("--gcm"), link_.address(), QStringLiteral("serve")};
  const bool is_started = QProcess::startDetached(program_, words);
  Q_EMIT notice(is_started ? Words::tr("Starting a GCM; it goes on when this window is closed")
                           : Words::tr("%1 could not be started").arg(program_));
}

}  // namespace tendon::gui
