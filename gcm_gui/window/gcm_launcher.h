#pragma once

#include <gcm_gui/session/link_state.h>

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Starts a GCM at the window's address, as a separate program that continues when the window is
/// closed.
class GcmLauncher : public QObject {
  Q_OBJECT

 public:
  /// `command` is `gcm` with the network options of the window.
  GcmLauncher(QStringList command, const LinkState& link, QObject* parent);

  void start();

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  const QStringList command_;
  const LinkState& link_;
};

}  // namespace tendon::gui
