#include <gcm_gui/session/network_reports.h>

#include <gcm_console/catalogue/event_choice.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/payload/json.h>

#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::milliseconds kDrainPeriod{100};
constexpr std::chrono::milliseconds kFollowPause{200};

}  // namespace

NetworkReports::NetworkReports(GcmClient& client, const CatalogueStore& store,
                               std::shared_ptr<GuiPoster> poster, QObject* parent)
    : SystemReports(parent),
      client_(client),
      store_(store),
      poster_(std::move(poster)),
      inbox_(std::make_shared<console::EventInbox>()) {
  connect(&drain_timer_, &QTimer::timeout, this, &NetworkReports::drain);
  follow_soon_.setSingleShot(true);
  follow_soon_.setInterval(kFollowPause);
  connect(&follow_soon_, &QTimer::timeout, this, &NetworkReports::follow);
  connect(&store, &CatalogueStore::changed, this, [this] {
    const bool is_planned = wanted_.empty() || follow_soon_.isActive();
    if (!is_planned) follow_soon_.start();
  });
}

NetworkReports::~NetworkReports() {
  for (const auto& [provided, listener] : listeners_) client_.StopListening(listener.id);
}

void NetworkReports::watchLog() { client_.WatchLog(); }

void NetworkReports::listen(const QObject* owner, const QStringList& patterns) {
  if (!known_owners_.contains(owner)) {
    known_owners_.insert(owner);
    connect(owner, &QObject::destroyed, this, [this, owner] {
      known_owners_.remove(owner);
      // Later, because a half-destroyed owner must not get the events that have already arrived.
      if (wanted_.erase(owner) > 0) follow_soon_.start();
    });
  }
  const auto known = wanted_.find(owner);
  if (known == wanted_.end() ? patterns.isEmpty() : known->second == patterns) return;
  if (patterns.isEmpty()) {
    wanted_.erase(owner);
  } else {
    wanted_[owner] = patterns;
  }
  follow();
}

void NetworkReports::follow() {
  std::vector<std::string> patterns;
  for (const auto& [owner, list] : wanted_) {
    for (const QString& pattern : list) patterns.push_back(pattern.toStdString());
  }
  std::map<InterfaceName, EventSubscription> fit;
  if (!patterns.empty()) {
    for (auto& one : console::MatchingEvents(store_.catalogue(), patterns)) {
      fit.emplace(one.provided, std::move(one));
    }
  }
  for (auto it = listeners_.begin(); it != listeners_.end();) {
    const auto wanted = fit.find(it->first);
    // An absent interface that was not removed may return. The client then resumes the subscription
    // by itself.
    const bool is_gone =
        wanted == fit.end() && store_.catalogue().FindProvided(it->first) == nullptr;
    if ((is_gone && !patterns.empty()) ||
        (wanted != fit.end() && wanted->second.events == it->second.events)) {
      if (wanted != fit.end()) fit.erase(wanted);
      ++it;
    } else {
      client_.StopListening(it->second.id);
      it = listeners_.erase(it);
    }
  }
  for (const auto& [provided, wanted] : fit) {
    listeners_[provided] = {wanted.events, client_.Listen(wanted, inbox_->SinkOf(wanted))};
  }
  if (listeners_.empty()) {
    drain();
    drain_timer_.stop();
  } else if (!drain_timer_.isActive()) {
    drain_timer_.start(kDrainPeriod);
  }
}

void NetworkReports::learn(const console::EventInbox::Content& content) {
  std::size_t next = 0;
  for (const EventSubscription& one : content.begun) {
    for (std::size_t i = 0; i < one.events.size(); ++i, ++next) {
      const MemberDescription& event = content.descriptions.at(next);
      if (TakesArgument(event.signature)) types_.want(event.signature.in, one.provided.process);
    }
  }
  for (const auto& [type, process] : types_.takeDue(SteadyClock().Now())) {
    client_.GetSchema(
        process, type, [this, poster = poster_, type = type](const Result<Schema>& schema) {
          poster->post([this, type, schema] { types_.onReply(type, schema, SteadyClock().Now()); });
        });
  }
}

std::optional<QString> NetworkReports::valueOf(const console::ReceivedEvent& event) const {
  const Signature& signature = event.description.signature;
  if (!TakesArgument(signature)) return QString();
  const Result<Schema>* type = types_.find(signature.in);
  if (type == nullptr) return std::nullopt;
  if (!type->ok()) {
    return Words::tr("%1 bytes: ").arg(event.value.size()) + ToQString(type->error().message);
  }
  const auto json = ToJson(**type, event.value);
  return ToQString(json ? *json : json.error().message);
}

void NetworkReports::drain() {
  console::EventInbox::Content content = inbox_->Take();
  learn(content);
  console::LostEvents lost = content.lost;
  for (auto& [event, lost_before] : content.events) {
    lost += lost_before;
    waiting_.push_back(std::move(event));
  }
  while (waiting_.size() > kMaxAtOnce) {
    ++lost.by_path[waiting_.front().path];
    waiting_.pop_front();
  }
  for (const auto& [path, count] : lost.by_path) Q_EMIT eventsLost(ToQString(path), count);
  std::vector<EventRecord> received;
  std::deque<console::ReceivedEvent> unread;
  for (console::ReceivedEvent& event : waiting_) {
    if (const auto value = valueOf(event)) {
      received.push_back({event.time_ns, ToQString(event.path), *value});
    } else {
      unread.push_back(std::move(event));
    }
  }
  waiting_ = std::move(unread);
  if (!received.empty()) Q_EMIT eventsArrived(received);
}

void NetworkReports::askHealth(Handler<message::SystemHealth> handler) {
  client_.GetHealth([poster = poster_, handler](const auto& health) {
    poster->post([handler, health] { handler(health); });
  });
}

void NetworkReports::askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) {
  client_.GetCounts(required, [poster = poster_, handler](const auto& counts) {
    poster->post([handler, counts] { handler(counts); });
  });
}

void NetworkReports::askFill(const std::string& process, const std::string& component,
                             Handler<MailboxFill> handler) {
  client_.GetFill(process, component, [poster = poster_, handler](const auto& fill) {
    poster->post([handler, fill] { handler(fill); });
  });
}

void NetworkReports::askHistory(const std::string& process,
                                Handler<message::ProcessHistoryState> handler) {
  client_.GetProcessHistory(process, [poster = poster_, handler](const auto& history) {
    poster->post([handler, history] { handler(history); });
  });
}

void NetworkReports::askChildren(Handler<message::Children> handler) {
  client_.GetChildren([poster = poster_, handler](const auto& children) {
    poster->post([handler, children] { handler(children); });
  });
}

void NetworkReports::askClasses(const std::string& process, Handler<message::Classes> handler) {
  client_.GetClasses(process, [poster = poster_, handler](const auto& classes) {
    poster->post([handler, classes] { handler(classes); });
  });
}

}  // namespace tendon::gui
