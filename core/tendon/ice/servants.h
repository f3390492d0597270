#pragma once

#include <Ice/Ice.h>
#include <tendon/ice/links.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

namespace tendon::ice {

/// Implements the interface Endpoint of tendon.ice without generated code. Passes each frame to the
/// link of the connection on which it arrived.
class EndpointServant : public Ice::Object {
 public:
  explicit EndpointServant(std::shared_ptr<Links> links) : links_(std::move(links)) {}

  bool _iceDispatch(IceInternal::Incoming& incoming, const Ice::Current& current) override;

 protected:
  /// Returns the link of a connection; null if it has no link.
  virtual std::shared_ptr<IceLink> LinkOf(const std::shared_ptr<Ice::Connection>& connection);

  [[nodiscard]] const std::shared_ptr<Links>& links() const { return links_; }

 private:
  bool Dispatch(std::span<const std::byte> parameters, const Ice::Current& current,
                IceInternal::Incoming& incoming);

  const std::shared_ptr<Links> links_;
};

/// The Endpoint of a listener. Makes a link from each new connection.
class AcceptingServant final : public EndpointServant {
 public:
  AcceptingServant(std::shared_ptr<Links> links, AcceptLink accept, std::uint64_t listener)
      : EndpointServant(std::move(links)), accept_(std::move(accept)), listener_(listener) {}

  /// Closes the accepted links and accepts no more links. All calls of OnClosed() have returned
  /// before this function returns.
  void Stop();

 private:
  std::shared_ptr<IceLink> LinkOf(const std::shared_ptr<Ice::Connection>& connection) override;

  std::mutex mutex_;
  AcceptLink accept_;
  const std::uint64_t listener_;
};

}  // namespace tendon::ice
