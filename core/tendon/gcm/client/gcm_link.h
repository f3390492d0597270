#pragma once

#include <tendon/gcm/client.h>
#include <tendon/gcm/client/log_feed.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/ask.h>
#include <tendon/process/description_pool.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon::client {

/// A viewer's channel to its GCM, and its copy of the catalogue, which the GCM updates. If the
/// channel breaks, it is opened again. Thread-safe.
class GcmLink final : public std::enable_shared_from_this<GcmLink> {
 public:
  /// A process that has a new address, or has returned.
  struct MovedProcess {
    std::string process;
    std::uint64_t instance = 0;  ///< the instance that runs now
  };
  /// The callbacks of the link. Only one is called at a time, and none after Stop().
  struct Events {
    std::shared_ptr<GcmListener> listener;  ///< may be null
    std::function<void(const std::vector<MovedProcess>& processes)> on_moved;
  };
  /// The middleware must exist until Stop() returns. The timer provides the timeouts.
  GcmLink(Middleware& middleware, GcmClient::Options options, Events events,
          std::shared_ptr<Worker> timer);

  void Start();
  /// Closes the channel. Waits for a running event callback, so it must not be called from an event
  /// callback.
  void Stop();

  Result<void> WaitUntilWatching();
  /// From now on, the listener receives the log.
  void WatchLog();
  void Resync();

  /// Returns the result of `read(catalogue)`. `read` is called while the lock is held, so it must
  /// be short.
  template <typename Read>
  auto WithCatalogue(Read&& read) const {
    const std::scoped_lock lock(mutex_);
    return read(catalogue_);
  }

  /// Sends a request whose reply may take `timeouts` times the timeout of the client.
  template <Payload ReplyBody, Message T>
  void Request(MessageType type, const T& value, std::function<void(Result<ReplyBody>)> handler,
               int timeouts = 1);

 private:
  class Handler;
  using SharedChannel = std::shared_ptr<Channel>;

  void Open();
  void OnOpened(const SharedChannel& channel);
  void OnClosed(const SharedChannel& channel, const Error& reason);
  void Watch(const SharedChannel& channel);
  void WatchLog(const SharedChannel& channel);
  template <typename Take>
  void ReportLog(const SharedChannel& channel, Take&& take);
  void Receive(const SharedChannel& channel, message::CatalogueSnapshot snapshot);
  void Receive(const SharedChannel& channel, message::Changes changes);
  void Receive(const SharedChannel& channel, message::LogRecords records);
  void ShareDescriptions(std::vector<CatalogueChange>& changes);
  void Renew(const std::weak_ptr<Channel>& weak);
  void OnLost(const Error& reason);
  void Tick();
  [[nodiscard]] std::chrono::nanoseconds RecentPause() const;
  [[nodiscard]] Error NoGcm() const;
  template <typename Call>
  void Report(Call&& call);

  Middleware& middleware_;
  const GcmClient::Options options_;
  const Events events_;
  const std::shared_ptr<Worker> timer_;

  std::mutex reporting_;  // held during event callbacks; locked before mutex_
  bool stopped_ = false;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  SharedChannel channel_;   // null while the channel is not open
  bool is_waiting_ = true;  // true until the snapshot arrives; changes are ignored
  bool wants_log_ = false;
  Catalogue catalogue_;
  DescriptionPool pool_;
  std::optional<Error> lost_;  // why there is no channel
  SteadyTime last_tick_ = SteadyClock().Now();
  SteadyTime awake_since_{};                     // end of the last pause of this program
  std::chrono::nanoseconds last_pause_{};        // length of the last pause
  std::chrono::nanoseconds unreported_pause_{};  // a pause that broke the link and must be reported
  LogFeed log_;
  Worker opener_{"client-gcm"};
};

template <Payload ReplyBody, Message T>
void GcmLink::Request(MessageType type, const T& value,
                      std::function<void(Result<ReplyBody>)> handler, int timeouts) {
  std::unique_lock lock(mutex_);
  if (const SharedChannel channel = channel_) {
    lock.unlock();
    const auto timeout = timeouts * options_.timeout;
    return Ask<ReplyBody>(*timer_, channel, type, value, timeout, std::move(handler));
  }
  timer_->Post([handler = std::move(handler), error = NoGcm()] { handler(error); });
}

}  // namespace tendon::client
