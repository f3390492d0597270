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

struct PendingConnects {
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
PendingConnects& TheConnects() {
  static auto* const connects = new PendingConnects;
  return *connects;
}

}  // namespace

ConnectCancellation::ConnectCancellation(std::thread::id thread) : thread_(thread) {
  PendingConnects& connects = TheConnects();
  const std::scoped_lock lock(connects.mutex);
  connects.ended.insert(thread_);
  for (const auto& [number, wait] : connects.all) {
    if (connects.AreOver(wait.thread)) wait.give_up();
  }
}

ConnectCancellation::~ConnectCancellation() {
  PendingConnects& connects = TheConnects();
  const std::scoped_lock lock(connects.mutex);
  connects.ended.erase(connects.ended.find(thread_));
}

CancellableConnect::CancellableConnect(std::function<void()> give_up) {
  PendingConnects& connects = TheConnects();
  const std::scoped_lock lock(connects.mutex);
  const auto thread = std::this_thread::get_id();
  if (connects.AreOver(thread)) give_up();
  number_ = ++connects.last_number;
  connects.all.emplace(number_, PendingConnect{thread, std::move(give_up)});
}

CancellableConnect::~CancellableConnect() {
  PendingConnects& connects = TheConnects();
  const std::scoped_lock lock(connects.mutex);
  connects.all.erase(number_);
}

bool AreConnectsCancelled() {
  PendingConnects& connects = TheConnects();
  const std::scoped_lock lock(connects.mutex);
  return connects.AreOver(std::this_thread::get_id());
}

Error ConnectCancelledError() {
  return {ErrorCode::kUnreachable, "this program is ending and does not wait for the connection"};
}

}  // namespace tendon
