#pragma once

#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>
#include <tendon/proxy/handle_table.h>
#include <tendon/proxy/provided_interface_proxy.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

namespace tendon {

class PeerLink;

/// Hears of links, on the worker.
class PeerListener {
 public:
  virtual ~PeerListener() = default;
  virtual void OnLinkClosed(const PeerLink& link, const Error& reason) = 0;
  /// The provided interface of one connection is gone; `handle` is our number of it.
  virtual void OnInterfaceClosed(const PeerLink& link, std::uint32_t handle,
                                 const Error& reason) = 0;
  /// A component over there has faulted, or was started anew.
  virtual void OnServerChanged() = 0;
};

/// The channel to one other process, opened by this one; all its connections to that process share
/// it. Closes by itself when the peer hangs.
class PeerLink final : public ChannelHandler, public std::enable_shared_from_this<PeerLink> {
 public:
  /// On the worker; blocks for at most a second. kUnreachable when another process is found there.
  static Result<std::shared_ptr<PeerLink>> Open(const ProcessContext& context,
                                                PeerListener& listener, const std::string& process,
                                                const std::string& address);

  PeerLink(std::shared_ptr<Worker> worker, PeerListener& listener)
      : worker_(std::move(worker)), listener_(listener) {}

  [[nodiscard]] const std::shared_ptr<Channel>& channel() const { return channel_; }
  [[nodiscard]] std::uint64_t instance() const { return channel_->peer().instance; }
  /// To the peer and back, as measured last; below 0 where it has not answered yet. Any thread.
  [[nodiscard]] std::chrono::nanoseconds round_trip() const { return round_trip_.Get(); }
  /// Our numbers of connections and event handlers.
  [[nodiscard]] HandleTable<ProvidedInterfaceProxy>& handles() { return handles_; }

 private:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override;
  void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                std::span<const std::byte> body) override;
  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override;

  const std::shared_ptr<Worker> worker_;
  PeerListener& listener_;  // on the worker only
  std::shared_ptr<Channel> channel_;
  Published<std::chrono::nanoseconds> round_trip_{std::chrono::nanoseconds(-1)};
  HandleTable<ProvidedInterfaceProxy> handles_;
};

}  // namespace tendon
