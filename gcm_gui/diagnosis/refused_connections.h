#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <tendon/gcm/catalogue.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <map>

namespace tendon::gui {

/// A connection that was requested through this window and refused.
struct RefusedConnection {
  InterfaceName provided;
  QString reason;
  std::int64_t when = 0;  ///< the time of the request, ns since 1970

  bool operator==(const RefusedConnection&) const = default;
};

/// The last refused connection of each required interface. An entry is removed when the interface
/// is connected, disconnected or removed. GUI thread.
class RefusedConnections : public QObject {
  Q_OBJECT

 public:
  using ByRequired = std::map<InterfaceName, RefusedConnection>;

  using QObject::QObject;

  [[nodiscard]] const ByRequired& all() const { return refused_; }
  /// Returns the last refused connection of `required`; null if there is none.
  [[nodiscard]] const RefusedConnection* find(const InterfaceName& required) const;

 public Q_SLOTS:
  void onActionFinished(const tendon::gui::Action& finished);
  void update(const tendon::Catalogue& catalogue);

 Q_SIGNALS:
  void changed();

 private:
  ByRequired refused_;
};

}  // namespace tendon::gui
