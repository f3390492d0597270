#pragma once

#include <gcm_gui/session/gcm_link.h>

#include <QObject>
#include <QString>

namespace tendon::gui {

/// Starts a GCM where the window looks for one. It is a program of its own, and goes on when the
/// window has ended.
class GcmStart : public QObject {
  Q_OBJECT

 public:
  /// `command` is `gcm` with the options of how the window talks.
  GcmStart(QStringList command, const GcmLink& link, QObject* parent);

  void start();

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  const QStringList command_;
  const GcmLink& link_;
};

}  // namespace tendon::gui
