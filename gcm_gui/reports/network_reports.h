#pragma once

#include <gcm_console/events/event_inbox.h>
#include <gcm_gui/reports/asked_types.h>
#include <gcm_gui/reports/system_reports.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/courier.h>

#include <QSet>
#include <QTimer>
#include <deque>
#include <map>
#include <memory>
#include <optional>

namespace tendon::gui {

/// The reports over the network, through the session's client. Events are handed out 10 times a
/// second, and no more at once than the window can show without a pause.
class NetworkReports final : public SystemReports {
  Q_OBJECT

 public:
  /// Events that are read at one go; more are counted as lost.
  static constexpr std::size_t kMostAtOnce = 1000;

  /// Client and store must outlive it; `courier` leads to the GUI thread.
  NetworkReports(GcmClient& client, const CatalogueStore& store, std::shared_ptr<Courier> courier,
                 QObject* parent = nullptr);
  ~NetworkReports() override;

  void watchLog() override;
  void listen(const QObject* owner, const QStringList& patterns) override;
  void askHealth(Handler<message::SystemHealth> handler) override;
  void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) override;
  void askFill(const std::string& process, const std::string& component,
               Handler<MailboxFill> handler) override;
  void askChildren(Handler<message::Children> handler) override;
  void askClasses(const std::string& process, Handler<message::Classes> handler) override;

  /// Listens to what is wanted and there, and to nothing else; a timer calls it.
  void follow();
  /// Hands out what has come; a timer calls it.
  void drain();

 private:
  struct Listener {
    std::vector<std::string> events;
    GcmClient::ListenerId id = 0;
  };

  void learn(const console::EventInbox::Content& content);
  /// Nothing while its type is being asked for.
  [[nodiscard]] std::optional<QString> valueOf(const console::HeardEvent& event) const;

  GcmClient& client_;
  const CatalogueStore& store_;
  std::shared_ptr<Courier> courier_;
  std::shared_ptr<console::EventInbox> inbox_;
  std::map<const QObject*, QStringList> wanted_;
  QSet<const QObject*> known_owners_;
  std::map<InterfaceName, Listener> listeners_;
  AskedTypes types_;
  std::deque<console::HeardEvent> waiting_;
  QTimer drain_timer_;
  QTimer follow_soon_;
};

}  // namespace tendon::gui
