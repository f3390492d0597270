#pragma once

#include <tendon/gcm/client.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <vector>

namespace tendon::gui {

/// An event that was raised.
struct EventRecord {
  /// The time of the event in ns since 1970 by this machine's clock, computed from the event's age
  /// on the steady clock.
  std::int64_t when = 0;
  QString path;   ///< "robot/arm/Control.GoalReached"
  QString value;  ///< JSON; empty if it has none

  bool operator==(const EventRecord&) const = default;
};

/// The system's reports in addition to its catalogue: log, events, and the health of processes and
/// connections. GUI thread; no function waits, and handlers are called in the GUI thread.
class SystemReports : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  template <typename T>
  using Handler = std::function<void(const Result<T>&)>;

  /// Starts the log of all processes, beginning with the records that the GCM has kept.
  virtual void watchLog() = 0;

  /// Sets the events that `owner` wants by patterns, "robot/arm/*" or "**"; replaces earlier ones.
  /// Ends when `owner` is destroyed. Every receiver gets the events of all owners.
  virtual void listen(const QObject* owner, const QStringList& patterns) = 0;

  virtual void askHealth(Handler<message::SystemHealth> handler) = 0;
  /// Requests the counters of a connection from its process. Errors are those of
  /// GcmClient::GetCounts().
  virtual void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) = 0;
  /// Requests the fill levels of a component's mailboxes.
  virtual void askFill(const std::string& process, const std::string& component,
                       Handler<MailboxFill> handler) = 0;
  /// Requests the processes started by the GCM. Errors are those of GcmClient::GetChildren().
  virtual void askChildren(Handler<message::Children> handler) = 0;
  /// Requests the classes from which a process can create components.
  virtual void askClasses(const std::string& process, Handler<message::Classes> handler) = 0;

 Q_SIGNALS:
  void logArrived(const tendon::LogBatch& batch);
  /// In order of arrival, except that events of a new type wait until the type is known.
  void eventsArrived(const std::vector<tendon::gui::EventRecord>& events);
  /// `count` further events were lost, because there was not enough room or time.
  void eventsLost(const QString& path, std::uint64_t count);
};

}  // namespace tendon::gui
