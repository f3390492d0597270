#pragma once

#include <Ice/Ice.h>
#include <IceStorm/IceStorm.h>
#include <tendon/base/result.h>

#include <memory>
#include <string>
#include <utility>

namespace tendon::ice {

/// Connects to a broker and checks that it is trusted: with TLS, by its certificate; without TLS,
/// by the user who owns the socket. The returned proxies use only the checked connection.
/// Therefore, another process that takes the port later receives no messages. The functions block
/// and throw exceptions of Ice. Thread-safe.
class BrokerConnection {
 public:
  BrokerConnection(std::shared_ptr<Ice::Communicator> communicator, bool is_certified)
      : communicator_(std::move(communicator)), is_certified_(is_certified) {}

  Result<std::shared_ptr<IceStorm::TopicManagerPrx>> Open(const std::string& broker) const;

  /// Returns a proxy for an object that the topic manager has returned. The connection of the proxy
  /// is checked in the same way.
  Result<std::shared_ptr<Ice::ObjectPrx>> Reach(
      const std::shared_ptr<Ice::ObjectPrx>& object) const;

  [[nodiscard]] bool is_certified() const { return is_certified_; }

 private:
  [[nodiscard]] Result<void> CheckPeer(const Ice::Connection& connection) const;

  const std::shared_ptr<Ice::Communicator> communicator_;
  const bool is_certified_;
};

}  // namespace tendon::ice
