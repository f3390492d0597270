#include <gcm_console/screen/connection_feed.h>

#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

namespace console {

using tendon::ConnectionCounts;
using tendon::ConnectionDescription;
using tendon::ConnectionState;

struct ConnectionFeed::Heard {
  std::mutex mutex;
  std::uint64_t id = 0;  // of the connection that is meant
  std::optional<ConnectionCounts> counts;
  double rate = -1.0;
  bool is_asking = false;
};

std::vector<ConnectionFigures> ConnectionFeed::Look() {
  constexpr std::chrono::seconds kBetween(1);
  const tendon::SteadyTime now = tendon::SteadyClock().Now();
  const bool asks = now >= next_;
  if (asks) next_ = now + kBetween;
  std::vector<ConnectionFigures> all;
  std::map<std::string, std::shared_ptr<Heard>> there;
  std::vector<ConnectionDescription> connections;
  client_.Look([&](const tendon::Catalog& catalog) { connections = catalog.connections(); });
  for (const ConnectionDescription& one : connections) {
    ConnectionFigures figures{.required = ToString(one.required),
                              .provided = ToString(one.provided),
                              .state = std::string(ToString(one.state))};
    auto known = heard_.extract(figures.required);
    const bool is_same = !known.empty() && known.mapped()->id == one.id;
    const auto heard = is_same ? known.mapped() : std::make_shared<Heard>();
    heard->id = one.id;
    there[figures.required] = heard;
    if (asks && one.state == ConnectionState::kActive) AskFor(one, heard);
    const std::scoped_lock lock(heard->mutex);
    figures.is_known = one.state == ConnectionState::kActive && heard->counts && heard->rate >= 0.0;
    if (figures.is_known) {
      const ConnectionCounts& counts = *heard->counts;
      figures.rate = heard->rate;
      if (counts.round_trip.count() >= 0) {
        figures.round_trip = std::chrono::duration<double>(counts.round_trip).count();
      }
      figures.lost = counts.refused + counts.replaced + counts.lost_events;
      figures.waiting = counts.waiting;
      figures.capacity = counts.capacity;
    }
    all.push_back(std::move(figures));
  }
  heard_ = std::move(there);
  return all;
}

/// One question at a time; the rate is by the clock of the process that counts.
void ConnectionFeed::AskFor(const ConnectionDescription& connection,
                            const std::shared_ptr<Heard>& heard) const {
  {
    const std::scoped_lock lock(heard->mutex);
    if (std::exchange(heard->is_asking, true)) return;
  }
  client_.GetCounts(connection.required, [heard](tendon::Result<ConnectionCounts> answer) {
    const std::scoped_lock lock(heard->mutex);
    heard->is_asking = false;
    if (!answer) {
      heard->counts.reset();
      heard->rate = -1.0;
      return;
    }
    const auto& before = heard->counts;
    const bool goes_on = before && answer->age > before->age && answer->taken >= before->taken;
    if (goes_on) {
      const std::chrono::duration<double> passed = answer->age - before->age;
      heard->rate = static_cast<double>(answer->taken - before->taken) / passed.count();
    }
    heard->counts = *answer;
  });
}

}  // namespace console
