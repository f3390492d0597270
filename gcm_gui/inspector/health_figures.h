#pragma once

#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/views/property_grid.h>

#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>
#include <cstdint>
#include <optional>
#include <string>

namespace tendon::gui {

/// The health of an interface's connection, as a short text and in full.
struct InterfaceHealth {
  QString brief;
  QString whole;

  bool operator==(const InterfaceHealth&) const = default;
};

/// The health of a process and of the connections of one of its components. Both are polled every
/// second while they are shown. The figures disappear if no reply comes.
class HealthFigures : public QObject {
  Q_OBJECT

 public:
  HealthFigures(SystemReports& reports, const CatalogueStore& store, QObject* parent = nullptr);

  /// Sets the process and the component to poll. If `component` is empty, only the process is
  /// polled; if `process` is empty, nothing.
  void show(const std::string& process, const std::string& component);

  /// Facts about the processor, the memory, the clock and the history.
  [[nodiscard]] QList<Property> processFacts() const;
  /// The health of the component's interfaces, by path of the interface.
  [[nodiscard]] const QHash<QString, InterfaceHealth>& interfaces() const { return interfaces_; }

 Q_SIGNALS:
  void changed();

 private:
  void ask();
  void askHistory();
  void askConnections(const ComponentDescription& component);
  void onCounts(const InterfaceName& required, const Result<ConnectionCounts>& counts);
  void onFill(const Result<MailboxFill>& fill);

  SystemReports& reports_;
  const CatalogueStore& store_;
  QTimer timer_;
  std::string process_;
  std::string component_;
  std::uint64_t shown_ = 0;  // number of the shown component; earlier replies are ignored
  message::SystemHealth health_;
  std::optional<message::ProcessHistoryState> history_;
  QHash<QString, InterfaceHealth> interfaces_;
};

}  // namespace tendon::gui
