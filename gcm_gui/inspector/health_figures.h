#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/views/property_grid.h>

#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>
#include <string>

namespace tendon::gui {

/// The health of an interface's connection, as a short text and in full.
struct InterfaceHealth {
  QString brief;
  QString whole;

  bool operator==(const InterfaceHealth&) const = default;
};

/// The health of a process and of the connections of one of its components, polled every second
/// while shown. The figures disappear if there is no answer.
class HealthFigures : public QObject {
  Q_OBJECT

 public:
  HealthFigures(SystemReports& reports, const CatalogueStore& store, QObject* parent = nullptr);

  /// An empty process shows nothing, an empty component only the process.
  void show(const std::string& process, const std::string& component);

  /// Processor, memory, clock.
  [[nodiscard]] QList<Property> processFacts() const;
  /// By the path of an interface of the component.
  [[nodiscard]] const QHash<QString, InterfaceHealth>& interfaces() const { return interfaces_; }

 Q_SIGNALS:
  void changed();

 private:
  void ask();
  void askConnections(const ComponentDescription& component);
  void onCounts(const InterfaceName& required, const Result<ConnectionCounts>& counts);
  void onFill(const Result<MailboxFill>& fill);

  SystemReports& reports_;
  const CatalogueStore& store_;
  QTimer timer_;
  std::string process_;
  std::string component_;
  std::uint64_t shown_ = 0;  // counts components; answers for earlier ones are ignored
  message::SystemHealth health_;
  QHash<QString, InterfaceHealth> interfaces_;
};

}  // namespace tendon::gui
