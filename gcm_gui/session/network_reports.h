#pragma once

#include <gcm_console/feeds/event_inbox.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/session/type_requests.h>

#include <QSet>
#include <QTimer>
#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// The reports of the system, received by the client of the session. Events are delivered 10 times
/// a second, and only as many as the window can show without delay.
class NetworkReports final : public SystemReports {
  Q_OBJECT

 public:
  /// The maximum number of events that are delivered at once. Further events count as lost.
  static constexpr std::size_t kMaxAtOnce = 1000;

  /// `client` and `store` must outlive this object. `poster` posts calls to the GUI thread.
  NetworkReports(GcmClient& client, const CatalogueStore& store, std::shared_ptr<GuiPoster> poster,
                 QObject* parent = nullptr);
  ~NetworkReports() override;

  void watchLog() override;
  void listen(const QObject* owner, const QStringList& patterns) override;
  void askHealth(Handler<message::SystemHealth> handler) override;
  void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) override;
  void askFill(const std::string& process, const std::string& component,
               Handler<MailboxFill> handler) override;
  void askHistory(const std::string& process,
                  Handler<message::ProcessHistoryState> handler) override;
  void askChildren(Handler<message::Children> handler) override;
  void askClasses(const std::string& process, Handler<message::Classes> handler) override;

  /// Subscribes to all requested events that exist now, and ends the other subscriptions; called by
  /// a timer.
  void follow();
  /// Delivers the events that have arrived; called by a timer.
  void drain();

 private:
  struct Listener {
    std::vector<std::string> events;
    GcmClient::ListenerId id = 0;
  };

  void learn(const console::EventInbox::Content& content);
  /// Returns the event's value as text. No value while the type of the event is being requested.
  [[nodiscard]] std::optional<QString> valueOf(const console::ReceivedEvent& event) const;

  GcmClient& client_;
  const CatalogueStore& store_;
  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<console::EventInbox> inbox_;
  std::map<const QObject*, QStringList> wanted_;
  QSet<const QObject*> known_owners_;
  std::map<InterfaceName, Listener> listeners_;
  TypeRequests types_;
  std::deque<console::ReceivedEvent> waiting_;
  QTimer drain_timer_;
  QTimer follow_soon_;
};

}  // namespace tendon::gui
