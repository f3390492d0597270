#pragma once

#include <tendon/gcm/client.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace tendon::gui {

/// An event that a component has raised.
struct EventRecord {
  /// The time of the event in ns since 1970 by this machine's clock. It is computed from the age of
  /// the event, which is measured on the steady clock.
  std::int64_t when = 0;
  QString path;   ///< "robot/arm/Control.GoalReached"
  QString value;  ///< JSON; empty if the event has no value

  bool operator==(const EventRecord&) const = default;
};

/// The reports of the system that are not in its catalogue: the log, events, and the health of
/// processes and connections. GUI thread. No function blocks, and handlers are called in the GUI
/// thread.
class SystemReports : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  template <typename T>
  using Handler = std::function<void(const Result<T>&)>;

  /// Subscribes to the log of all processes. It begins with the records that the GCM has stored.
  virtual void watchLog() = 0;

  /// Sets the patterns of the events that `owner` wants, such as "robot/arm/*" or "**". They
  /// replace the earlier patterns of `owner`. Ends when `owner` is destroyed. eventsArrived() has
  /// the events of all owners.
  virtual void listen(const QObject* owner, const QStringList& patterns) = 0;

  virtual void askHealth(Handler<message::SystemHealth> handler) = 0;
  /// Requests the counters of a connection from its process. Fails like GcmClient::GetCounts().
  virtual void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) = 0;
  /// Requests the fill levels of the mailboxes of a component.
  virtual void askFill(const std::string& process, const std::string& component,
                       Handler<MailboxFill> handler) = 0;
  /// Requests the state of a process's history.
  virtual void askHistory(const std::string& process,
                          Handler<message::ProcessHistoryState> handler) = 0;
  /// Requests the list of processes that the GCM has started. Fails like GcmClient::GetChildren().
  virtual void askChildren(Handler<message::Children> handler) = 0;
  /// Requests the classes from which a process can create components.
  virtual void askClasses(const std::string& process, Handler<message::Classes> handler) = 0;

 Q_SIGNALS:
  /// Emitted when a recording jumps to another moment. Discard all earlier log records and events.
  /// logArrived() and eventsArrived() then deliver the records and events up to the new moment.
  void beganAgain();
  void logArrived(const tendon::LogBatch& batch);
  /// Emitted with events in the order of arrival. An event of an unknown type is delayed until the
  /// type is known.
  void eventsArrived(const std::vector<tendon::gui::EventRecord>& events);
  /// Emitted when `count` further events were lost because of missing memory or time.
  void eventsLost(const QString& path, std::uint64_t count);
};

}  // namespace tendon::gui
