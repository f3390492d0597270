#include <gcm_console/feeds/connection_feed.h>

#include <tendon/base/clock.h>

#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

namespace console {
namespace {

using tendon::ConnectionCounts;
using tendon::ConnectionDescription;
using tendon::ConnectionState;
using tendon::SteadyClock;

/// Returns true if the process of the connection can answer a request for its counters.
bool HasCounters(const tendon::Catalogue& catalogue, const ConnectionDescription& connection) {
  const auto* owner = catalogue.FindProcess(connection.required.process);
  return connection.state == ConnectionState::kActive && owner != nullptr &&
         owner->process.state == tendon::ProcessState::kAlive;
}

}  // namespace

struct ConnectionFeed::LatestReply {
  std::uint64_t id = 0;  // id of the connection
  bool has_counters = false;

  std::mutex mutex;  // guards the members below
  std::optional<ConnectionCounts> counts;
  double rate = -1.0;

  /// Sets the figures that are known.
  void Fill(ConnectionFigures& figures) {
    const std::scoped_lock lock(mutex);
    figures.is_known = figures.state == ToString(ConnectionState::kActive) && counts && rate >= 0.0;
    figures.is_awaited = has_counters && !figures.is_known;
    if (!figures.is_known) return;
    figures.rate = rate;
    if (counts->round_trip.count() >= 0) {
      figures.round_trip = std::chrono::duration<double>(counts->round_trip).count();
    }
    figures.lost = counts->refused + counts->replaced + counts->lost_events;
    figures.waiting = counts->waiting;
    figures.capacity = counts->capacity;
  }

  /// Stores a reply. The rate is computed with the clock of the process that counts.
  void OnReply(const tendon::Result<ConnectionCounts>& reply) {
    const std::scoped_lock lock(mutex);
    if (!reply) {
      counts.reset();
      rate = -1.0;
      return;
    }
    const bool goes_on = counts && reply->age > counts->age && reply->taken >= counts->taken;
    if (goes_on) {
      const std::chrono::duration<double> passed = reply->age - counts->age;
      rate = static_cast<double>(reply->taken - counts->taken) / passed.count();
    }
    counts = *reply;
  }
};

std::vector<ConnectionFigures> ConnectionFeed::Look(const std::string& filter) {
  std::vector<ConnectionFigures> all;
  std::map<tendon::InterfaceName, std::shared_ptr<LatestReply>> there;
  client_.WithCatalogue([&](const tendon::Catalogue& catalogue) {
    for (const ConnectionDescription& one : catalogue.connections()) {
      ConnectionFigures figures{.required = ToString(one.required),
                                .provided = ToString(one.provided),
                                .state = std::string(ToString(one.state))};
      if ((figures.required + " " + figures.provided).find(filter) == filter.npos) continue;
      auto known = latest_.extract(one.required);
      const bool is_same = !known.empty() && known.mapped()->id == one.id;
      const auto latest = is_same ? known.mapped() : std::make_shared<LatestReply>();
      latest->id = one.id;
      latest->has_counters = HasCounters(catalogue, one);
      latest->Fill(figures);
      there[one.required] = latest;
      all.push_back(std::move(figures));
    }
  });
  latest_ = std::move(there);
  AskSome();
  return all;
}

void ConnectionFeed::AskSome() const {
  std::vector<tendon::InterfaceName> there;
  for (const auto& [required, latest] : latest_) {
    if (latest->has_counters) there.push_back(required);
  }
  for (const auto& required : throttle_->Begin(there, SteadyClock().Now())) {
    // The destructor of `query` calls End(). It runs when the last copy of the handler is
    // destroyed, even if no reply arrives.
    const std::shared_ptr<void> query(
        nullptr, [throttle = throttle_, required](void* /*nothing*/) { throttle->End(required); });
    client_.GetCounts(required, [query, latest = latest_.at(required)](const auto& reply) {
      latest->OnReply(reply);
    });
  }
}

}  // namespace console
