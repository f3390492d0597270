#include <tendon/middleware/handshake/openings.h>

#include <map>
#include <mutex>
#include <utility>

namespace tendon {
namespace {

struct Waits {
  std::mutex mutex;
  int enders = 0;
  std::uint64_t last_number = 0;
  std::map<std::uint64_t, std::function<void()>> all;  // how each is ended
};

/// Lives longer than any thread that may wait.
Waits& TheWaits() {
  static auto* const waits = new Waits;
  return *waits;
}

}  // namespace

NoMoreOpening::NoMoreOpening() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  ++waits.enders;
  for (const auto& [number, give_up] : waits.all) give_up();
}

NoMoreOpening::~NoMoreOpening() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  --waits.enders;
}

WaitForLink::WaitForLink(std::function<void()> give_up) {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  if (waits.enders > 0) give_up();
  number_ = ++waits.last_number;
  waits.all.emplace(number_, std::move(give_up));
}

WaitForLink::~WaitForLink() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  waits.all.erase(number_);
}

bool IsOpeningOver() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  return waits.enders > 0;
}

Error OpeningIsOver() {
  return {ErrorCode::kUnreachable, "this program ends, and waits for no link any more"};
}

}  // namespace tendon
