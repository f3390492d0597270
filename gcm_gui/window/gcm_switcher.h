#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace tendon::gui {

class LinkState;

/// Shows a GCM at another address in a new window that replaces this one. A window that hosts its
/// GCM stays open, because others may use that GCM.
class GcmSwitcher : public QObject {
  Q_OBJECT

 public:
  /// Starts this program with these arguments; returns false on failure.
  using Launch = std::function<bool(const QStringList& arguments)>;

  GcmSwitcher(QWidget& window, const LinkState& link, Launch launch = &GcmSwitcher::startProgram);

  /// Asks the user for the address.
  void ask();

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  static bool startProgram(const QStringList& arguments);
  void goTo(const QString& address);

  QWidget& window_;
  const LinkState& link_;
  Launch launch_;
};

/// The arguments for a program that shows the GCM at `address` with the same options as this one;
/// without this program's system file.
[[nodiscard]] QStringList ArgumentsFor(const QStringList& mine, const QString& address);

}  // namespace tendon::gui
