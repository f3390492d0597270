#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace tendon::gui {

class LinkState;

/// Shows a GCM at another address in a new window, and closes this window. A window that hosts its
/// own GCM stays open, because other programs may use that GCM.
class GcmSwitcher : public QObject {
  Q_OBJECT

 public:
  /// Starts this program with these arguments. Returns false on failure.
  using Launch = std::function<bool(const QStringList& arguments)>;

  GcmSwitcher(QWidget& window, const LinkState& link, Launch launch = &GcmSwitcher::startProgram);

  /// Asks the user for the address.
  void ask();

 Q_SIGNALS:
  /// Emitted with one sentence for the user.
  void notice(const QString& text);

 private:
  static bool startProgram(const QStringList& arguments);
  void goTo(const QString& address);

  QWidget& window_;
  const LinkState& link_;
  Launch launch_;
};

/// Returns the arguments for a program that shows the GCM at `address`, with the same options as
/// this program (`mine`) but without its system file.
[[nodiscard]] QStringList ArgumentsFor(const QStringList& mine, const QString& address);

}  // namespace tendon::gui
