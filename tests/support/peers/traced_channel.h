#pragma once

#include <support/peers/wrapped.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/loopback.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon::test {

/// A middleware that records the memory address of each frame that is sent on its links. Refuses
/// frames while it has no room.
class TracedMiddleware final : public WrappedMiddleware {
 public:
  using WrappedMiddleware::WrappedMiddleware;

  /// The addresses of the frames of this type, in the order in which they were sent.
  [[nodiscard]] std::vector<const std::byte*> PlacesOf(MessageType type) const {
    std::vector<const std::byte*> places;
    const std::scoped_lock lock(traces_->mutex);
    for (const auto& [sent, place] : traces_->places) {
      if (sent == type) places.push_back(place);
    }
    return places;
  }
  void SetRoom(bool has_room) { traces_->has_room = has_room; }

  Result<std::shared_ptr<Link>> Open(const std::string& address,
                                     std::shared_ptr<LinkHandler> handler,
                                     std::chrono::milliseconds timeout) override {
    auto opened = WrappedMiddleware::Open(address, std::move(handler), timeout);
    if (!opened) return opened;
    return std::shared_ptr<Link>(std::make_shared<TracedLink>(*std::move(opened), traces_));
  }

 private:
  struct Traces {
    std::mutex mutex;
    std::vector<std::pair<MessageType, const std::byte*>> places;
    std::atomic<bool> has_room{true};
  };

  class TracedLink final : public WrappedLink {
   public:
    TracedLink(std::shared_ptr<Link> below, std::shared_ptr<Traces> traces)
        : WrappedLink(std::move(below)), traces_(std::move(traces)) {}

    Status Send(std::span<const std::byte> frame, Delivery delivery) override {
      if (!traces_->has_room) return Status::kQueueFull;
      if (const auto header = ReadWholeFrame(frame)) {
        const std::scoped_lock lock(traces_->mutex);
        traces_->places.emplace_back(header->type, frame.data());
      }
      return WrappedLink::Send(frame, delivery);
    }

   private:
    const std::shared_ptr<Traces> traces_;
  };

  const std::shared_ptr<Traces> traces_ = std::make_shared<Traces>();
};

/// A channel over loopback that records the addresses of the frames that it sends, and a peer that
/// records the notices that arrive.
class TracedChannel {
 public:
  struct Notice {
    std::uint32_t handle = 0;
    Bytes body;

    bool operator==(const Notice&) const = default;
  };

  TracedChannel() {
    const Hello hello{.name = "test", .cookie = 1};
    listener_ = *server_.Listen("127.0.0.1:0", Channel::Acceptor(hello, [this] { return peer_; }));
    channel_ = *Channel::Open(client_, listener_->address(), hello,
                              std::make_shared<ChannelHandler>(), std::chrono::seconds(20));
  }
  TracedChannel(const TracedChannel&) = delete;
  TracedChannel& operator=(const TracedChannel&) = delete;
  ~TracedChannel() {
    channel_->Close();
    listener_.reset();
  }

  [[nodiscard]] const std::shared_ptr<Channel>& get() const { return channel_; }
  Channel* operator->() const { return channel_.get(); }

  /// Does the same as TracedMiddleware::PlacesOf() for this channel.
  [[nodiscard]] std::vector<const std::byte*> PlacesOf(MessageType type) const {
    return client_.PlacesOf(type);
  }
  void SetRoom(bool has_room) { client_.SetRoom(has_room); }
  /// The notices that have arrived, in order.
  [[nodiscard]] std::vector<Notice> notices() const {
    const std::scoped_lock lock(peer_->mutex);
    return peer_->notices;
  }

 private:
  struct Peer final : ChannelHandler {
    void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                  std::span<const std::byte> body) override {
      const std::scoped_lock lock(mutex);
      notices.push_back({header.handle, Bytes(body.begin(), body.end())});
    }

    std::mutex mutex;
    std::vector<Notice> notices;
  };

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  LoopbackMiddleware server_{network_};
  TracedMiddleware client_{std::make_shared<LoopbackMiddleware>(network_)};
  const std::shared_ptr<Peer> peer_ = std::make_shared<Peer>();
  std::unique_ptr<Listener> listener_;
  std::shared_ptr<Channel> channel_;
};

}  // namespace tendon::test
