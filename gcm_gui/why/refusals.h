#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <tendon/gcm/catalog.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>

namespace tendon::gui {

/// A connection that was asked for through this window, and not made.
struct RefusedConnection {
  InterfaceName provided;
  QString reason;
  std::int64_t when = 0;  ///< it was asked for, ns since 1970

  bool operator==(const RefusedConnection&) const = default;
};

/// What was refused last of each required interface: until it is connected after all, is
/// disconnected, or goes. GUI thread.
class Refusals : public QObject {
  Q_OBJECT

 public:
  using ByRequired = std::map<InterfaceName, RefusedConnection>;

  using QObject::QObject;

  [[nodiscard]] const ByRequired& all() const { return refused_; }
  /// Null where nothing was refused.
  [[nodiscard]] const RefusedConnection* find(const InterfaceName& required) const;

 public Q_SLOTS:
  void hear(const tendon::gui::Action& finished);
  void update(const tendon::Catalog& catalogue);

 Q_SIGNALS:
  void changed();

 private:
  ByRequired refused_;
};

}  // namespace tendon::gui
