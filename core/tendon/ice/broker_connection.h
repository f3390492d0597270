#pragma once

#include <Ice/Ice.h>
#include <IceStorm/IceStorm.h>
#include <tendon/base/result.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// Connects to a broker and checks that it is ours: by its certificate, or without TLS by the user
/// who owns the socket. The returned proxies use only this connection, so that a later process on
/// the port gets no messages. Thread-safe; functions block, and throw exceptions of Ice.
class BrokerConnection {
 public:
  BrokerConnection(std::shared_ptr<Ice::Communicator> communicator, bool is_certified)
      : communicator_(std::move(communicator)), is_certified_(is_certified) {}

  Result<std::shared_ptr<IceStorm::TopicManagerPrx>> Open(const std::string& broker) const;

  /// A proxy for an object named by the topic manager, over a connection checked in the same way.
  Result<std::shared_ptr<Ice::ObjectPrx>> Reach(
      const std::shared_ptr<Ice::ObjectPrx>& object) const;

  [[nodiscard]] bool is_certified() const { return is_certified_; }

 private:
  [[nodiscard]] Result<void> CheckPeer(const Ice::Connection& connection) const;

  const std::shared_ptr<Ice::Communicator> communicator_;
  const bool is_certified_;
};

}  // namespace tendon::ice
