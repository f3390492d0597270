#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/connection_checks.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <map>
#include <optional>

namespace tendon::gui {

/// What is wrong with a connection that stands, in words; empty where nothing is. `before` are its
/// counts when it was looked at last.
[[nodiscard]] QString HealthWarning(const ConnectionCounts& now,
                                    const std::optional<ConnectionCounts>& before);

/// How the connections do, while somebody looks: asks about one of them a second, never about a
/// second before the first has answered, however many there are.
class EdgeHealth : public QObject {
  Q_OBJECT

 public:
  EdgeHealth(const CatalogueStore& store, ConnectionChecks& checks, QObject* parent = nullptr);

 public Q_SLOTS:
  /// Nothing is asked while nobody does.
  void setLooking(bool looking);
  /// Asks about the next one.
  void look();

 Q_SIGNALS:
  /// Without a warning nothing is wrong.
  void found(const tendon::InterfaceName& required, const QString& warning);

 private:
  void hear(const InterfaceName& required, const Result<ConnectionCounts>& counts);

  const CatalogueStore& store_;
  ConnectionChecks& checks_;
  QTimer second_;
  InterfaceName last_;  // the one that was asked about last
  bool is_asking_ = false;
  std::map<InterfaceName, ConnectionCounts> known_;
};

}  // namespace tendon::gui
