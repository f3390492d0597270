#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace tendon::gui {

/// Goes over to a GCM at another address: with a window of its own, in place of this one.
class OtherGcm : public QObject {
  Q_OBJECT

 public:
  /// Starts this program with these arguments; false where it does not.
  using Launch = std::function<bool(const QStringList& arguments)>;

  explicit OtherGcm(QWidget& window, Launch launch = &OtherGcm::startProgram);

  /// Asks for the address.
  void ask();

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  static bool startProgram(const QStringList& arguments);
  void goTo(const QString& address);

  QWidget& window_;
  Launch launch_;
};

/// Those of a program that is to show the GCM at `address` as this one shows its own.
[[nodiscard]] QStringList ArgumentsFor(const QStringList& mine, const QString& address);

}  // namespace tendon::gui
