#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace tendon::gui {

class GcmLink;

/// Goes over to a GCM at another address: with a window of its own, in place of this one. A window
/// that hosts its GCM stays, for others may use that.
class OtherGcm : public QObject {
  Q_OBJECT

 public:
  /// Starts this program with these arguments; false where it does not.
  using Launch = std::function<bool(const QStringList& arguments)>;

  OtherGcm(QWidget& window, const GcmLink& link, Launch launch = &OtherGcm::startProgram);

  /// Asks for the address.
  void ask();

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  static bool startProgram(const QStringList& arguments);
  void goTo(const QString& address);

  QWidget& window_;
  const GcmLink& link_;
  Launch launch_;
};

/// Those of a program that is to show the GCM at `address` as this one shows its own; without the
/// system file that this one was to bring up there.
[[nodiscard]] QStringList ArgumentsFor(const QStringList& mine, const QString& address);

}  // namespace tendon::gui
