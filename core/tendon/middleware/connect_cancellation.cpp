#include <tendon/middleware/connect_cancellation.h>

#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace tendon {
namespace {

struct PendingConnect {
  std::thread::id thread;
  std::function<void()> give_up;
};

struct Waits {
  /// Returns true if attempts of the thread are cancelled. Called while the mutex is held.
  [[nodiscard]] bool AreOver(std::thread::id thread) const {
    return ended.contains(std::thread::id()) || ended.contains(thread);
  }

  std::mutex mutex;
  std::multiset<std::thread::id> ended;  // a default-constructed id means all threads
  std::uint64_t last_number = 0;
  std::map<std::uint64_t, PendingConnect> all;
};

/// Never destroyed, because threads may use it until the program ends.
Waits& TheWaits() {
  static auto* const waits = new Waits;
  return *waits;
}

}  // namespace

ConnectCancellation::ConnectCancellation(std::thread::id thread) : thread_(thread) {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  waits.ended.insert(thread_);
  for (const auto& [number, wait] : waits.all) {
    if (waits.AreOver(wait.thread)) wait.give_up();
  }
}

ConnectCancellation::~ConnectCancellation() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  waits.ended.erase(waits.ended.find(thread_));
}

CancellableConnect::CancellableConnect(std::function<void()> give_up) {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  const auto thread = std::this_thread::get_id();
  if (waits.AreOver(thread)) give_up();
  number_ = ++waits.last_number;
  waits.all.emplace(number_, PendingConnect{thread, std::move(give_up)});
}

CancellableConnect::~CancellableConnect() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  waits.all.erase(number_);
}

bool AreConnectsCancelled() {
  Waits& waits = TheWaits();
  const std::scoped_lock lock(waits.mutex);
  return waits.AreOver(std::this_thread::get_id());
}

Error ConnectCancelledError() {
  return {ErrorCode::kUnreachable, "this program is ending and does not wait for the connection"};
}

}  // namespace tendon
