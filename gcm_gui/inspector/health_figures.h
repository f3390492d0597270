#pragma once

#include <gcm_gui/reports/system_reports.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/views/fact_grid.h>

#include <QHash>
#include <QObject>
#include <QString>
#include <QTimer>
#include <string>

namespace tendon::gui {

/// How the connection of an interface does: in a word or two, and in whole.
struct InterfaceHealth {
  QString brief;
  QString whole;

  bool operator==(const InterfaceHealth&) const = default;
};

/// How a process and the connections of one of its components do, asked each second while they are
/// shown. What does not answer keeps its last figures out of sight.
class HealthFigures : public QObject {
  Q_OBJECT

 public:
  HealthFigures(SystemReports& reports, const CatalogueStore& store, QObject* parent = nullptr);

  /// An empty process for none, an empty component for the process alone.
  void show(const std::string& process, const std::string& component);

  /// Processor, memory, clock.
  [[nodiscard]] QList<Fact> processFacts() const;
  /// By path of an interface of the component.
  [[nodiscard]] const QHash<QString, InterfaceHealth>& interfaces() const { return interfaces_; }

 Q_SIGNALS:
  void changed();

 private:
  void ask();
  void askConnections(const ComponentDescription& component);
  void hearCounts(const InterfaceName& required, const Result<ConnectionCounts>& counts);
  void hearFill(const Result<MailboxFill>& fill);

  SystemReports& reports_;
  const CatalogueStore& store_;
  QTimer timer_;
  std::string process_;
  std::string component_;
  std::uint64_t shown_ = 0;  // what was asked for another one tells nothing
  message::SystemHealth health_;
  QHash<QString, InterfaceHealth> interfaces_;
};

}  // namespace tendon::gui
