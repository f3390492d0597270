#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/clock_offset.h>
#include <tendon/process/context.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/handle_table.h>
#include <tendon/proxy/provided_interface_proxy.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

class PeerLink;

/// Receives changes of links, on the worker.
class PeerListener {
 public:
  virtual ~PeerListener() = default;
  virtual void OnLinkClosed(const PeerLink& link, const Error& reason) = 0;
  /// Called when the provided interface of one connection no longer exists. `handle` is the number
  /// that this end has issued for the connection.
  virtual void OnInterfaceClosed(const PeerLink& link, std::uint32_t handle,
                                 const Error& reason) = 0;
  /// Called when a remote component has faulted or was restarted.
  virtual void OnServerChanged() = 0;
};

/// The channel to one other process. This process has opened the channel, and all connections to
/// the other process share it. Closes itself if the peer hangs.
class PeerLink final : public ChannelHandler, public std::enable_shared_from_this<PeerLink> {
 public:
  using Opened = std::function<void(const Result<std::shared_ptr<PeerLink>>&)>;

  /// Opens a link within a second, like OpenChannel(). Returns kUnreachable if a different process
  /// answers at the address.
  static void Open(const ProcessContext& context, PeerListener& listener,
                   const std::string& process, const std::string& address, Opened opened);

  PeerLink(std::shared_ptr<Worker> worker, PeerListener& listener)
      : worker_(std::move(worker)), listener_(listener) {}

  [[nodiscard]] const std::shared_ptr<Channel>& channel() const { return channel_; }
  [[nodiscard]] std::uint64_t instance() const { return channel_->peer().instance; }
  /// The last measured round trip; below 0 before the first reply. Any thread.
  [[nodiscard]] std::chrono::nanoseconds round_trip() const { return round_trip_.Get(); }
  /// The time since the peer last answered; it is pinged twice a second.
  [[nodiscard]] std::chrono::nanoseconds silence() const {
    return SteadyClock().Now() - last_heard_.Get();
  }
  /// Makes copies of remote values, in the order of `mirrored`. Updates each copy as long as
  /// another object holds it. Call it in a thread of the middleware, before the first value
  /// arrives.
  using MirroredValues = std::vector<std::shared_ptr<MirroredValue>>;
  Result<MirroredValues> MakeCopies(const message::MirrorReply& mirrored);
  /// The numbers that this end has issued for connections and event handlers.
  [[nodiscard]] HandleTable<ProvidedInterfaceProxy>& handles() { return handles_; }

 private:
  /// Starts to use an opened channel. Called on the worker.
  void Begin(const std::shared_ptr<Channel>& channel);
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override;
  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) override;
  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override;
  /// Handles kRows and kRowsEnded. Unsubscribes from copies that nobody uses any more.
  void OnRows(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
              std::span<const std::byte> body);
  void EndUnread();
  void OnMirrorEnabled(std::uint32_t handle, std::span<const std::byte> body);
  void Put(MirroredValue& value, std::int64_t time, std::span<const std::byte> body);

  const std::shared_ptr<Worker> worker_;
  PeerListener& listener_;  // used only on the worker
  std::shared_ptr<Channel> channel_;
  Published<std::chrono::nanoseconds> round_trip_{std::chrono::nanoseconds(-1)};
  Published<SteadyTime> last_heard_;
  HandleTable<ProvidedInterfaceProxy> handles_;

  std::mutex mutex_;                                                // guards the members below
  ClockOffset clock_;                                               // the peer's clock
  std::map<std::uint32_t, std::weak_ptr<MirroredValue>> mirrored_;  // by the peer's handles
};

/// A request for the provided interface of another process, made for a required interface of this
/// process.
struct InterfaceRequest {
  message::OpenInterface open;
  std::chrono::milliseconds read_deadline{0};
  std::vector<std::string> mirrored{};         ///< functions that read local copies
  std::shared_ptr<SerialExecutor> executor{};  ///< for the events; null if not needed
};

using OpenedInterface = Result<std::shared_ptr<ProvidedInterfaceProxy>>;

/// Asks the peer for the interface and makes its proxy. Registers the proxy at the link under
/// `wanted.open.handle`. Calls `done` in a thread of the middleware, before the proxy receives
/// messages from the peer.
void OpenProvided(const std::shared_ptr<NetworkThread>& network,
                  const std::shared_ptr<PeerLink>& link, const InterfaceRequest& wanted,
                  const std::function<void(const OpenedInterface&)>& done);

}  // namespace tendon
