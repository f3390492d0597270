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
struct HeardEvent {
  /// When it was raised, by the steady clock of its process: ns since 1970, by this machine's
  /// clock.
  std::int64_t when = 0;
  QString path;   ///< "robot/arm/Control.GoalReached"
  QString value;  ///< JSON; empty where it carries none

  bool operator==(const HeardEvent&) const = default;
};

/// What the system tells besides its catalogue: log, events, and how its processes and connections
/// do. Lives in the GUI thread; nothing here waits, and handlers are called in the GUI thread.
class SystemReports : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  template <typename T>
  using Handler = std::function<void(const Result<T>&)>;

  /// From now on the log of all processes arrives, what the GCM has kept of it first.
  virtual void watchLog() = 0;

  /// From now on `owner` wants the events that fit these patterns, "robot/arm/*" or "**", and no
  /// others. Forgotten when the owner dies. All events that anyone wants arrive at everybody.
  virtual void listen(const QObject* owner, const QStringList& patterns) = 0;

  virtual void askHealth(Handler<message::SystemHealth> handler) = 0;
  /// Of the connection of a required interface; asks its process: errors of GcmClient::GetCounts().
  virtual void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) = 0;
  /// Of the mailboxes of a component.
  virtual void askFill(const std::string& process, const std::string& component,
                       Handler<MailboxFill> handler) = 0;
  /// The processes that the GCM has started: errors of GcmClient::GetChildren().
  virtual void askChildren(Handler<message::Children> handler) = 0;
  /// Of which classes a process makes components.
  virtual void askClasses(const std::string& process, Handler<message::Classes> handler) = 0;

 Q_SIGNALS:
  void logArrived(const tendon::LogBatch& batch);
  /// In the order of their coming, except that those of a new type wait until it is known.
  void eventsArrived(const std::vector<tendon::gui::HeardEvent>& events);
  /// So many more were raised for which there was no room, or no time.
  void eventsLost(const QString& path, std::uint64_t count);
};

}  // namespace tendon::gui
