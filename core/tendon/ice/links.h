#pragma once

#include <Ice/Ice.h>
#include <tendon/middleware/middleware.h>

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace tendon::ice {

class Links;

/// One connection of Ice, either end of it. Callbacks of Ice hold it by shared pointers only.
class IceLink final : public Link, public std::enable_shared_from_this<IceLink> {
 public:
  /// `door` names the listener that accepted it, or is 0.
  IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t door);

  Status Send(std::span<const std::byte> frame) override;
  void Close() override;
  [[nodiscard]] std::string peer() const override { return peer_; }

  /// Before the first frame is delivered.
  void SetHandler(std::shared_ptr<LinkHandler> handler);
  void Deliver(std::span<const std::byte> frame);
  /// Closes because of what the peer did, after answering it.
  void Fail(const Error& reason);
  void CloseAtOnce();

 private:
  friend class Links;

  bool StartClosing(const Error& reason);
  void OnSent(std::size_t size);
  /// The connection is gone, whatever the cause.
  void OnGone();

  const std::shared_ptr<Ice::Connection> connection_;
  const std::shared_ptr<Ice::ObjectPrx> peer_endpoint_;
  const std::uint64_t door_;
  const std::string peer_;

  std::mutex delivery_;  // held during a call of the handler
  std::shared_ptr<LinkHandler> handler_;

  std::mutex mutex_;
  std::optional<Error> reason_;  // why it is closed, or about to be
  std::size_t unsent_ = 0;       // bytes
};

/// The links of one communicator. Thread-safe.
class Links {
 public:
  /// From now on the connection's frames reach the link, and its end, too.
  static void Add(const std::shared_ptr<Links>& links, const std::shared_ptr<IceLink>& link);

  std::shared_ptr<IceLink> Find(const std::shared_ptr<Ice::Connection>& connection);

  /// Closes the links accepted at `door`, or for 0 all that there are or will be; when it returns
  /// their handlers have heard it.
  void CloseAll(std::uint64_t door);

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool is_shut_ = false;
  std::map<Ice::Connection*, std::shared_ptr<IceLink>> links_;
};

/// The identity of the endpoint at both ends.
Ice::Identity EndpointIdentity();

}  // namespace tendon::ice
