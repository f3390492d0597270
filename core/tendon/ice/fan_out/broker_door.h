#pragma once

#include <Ice/Ice.h>
#include <IceStorm/IceStorm.h>
#include <tendon/base/result.h>

#include <memory>
#include <string>

namespace tendon::ice {

/// The way to a broker, which must be ours: by its certificate, or, without TLS, because the socket
/// belongs to this user. Proxies that come of it are of that one connection, so that nothing is
/// said to who takes the port later. Thread-safe; functions block, and throw what Ice throws.
class BrokerDoor {
 public:
  BrokerDoor(std::shared_ptr<Ice::Communicator> communicator, bool is_certified)
      : communicator_(std::move(communicator)), is_certified_(is_certified) {}

  Result<std::shared_ptr<IceStorm::TopicManagerPrx>> Open(const std::string& broker) const;

  /// An object that the manager told us of, by a connection that was found good as well.
  Result<std::shared_ptr<Ice::ObjectPrx>> Reach(
      const std::shared_ptr<Ice::ObjectPrx>& object) const;

  [[nodiscard]] bool is_certified() const { return is_certified_; }

 private:
  [[nodiscard]] Result<void> Judge(const Ice::Connection& connection) const;

  const std::shared_ptr<Ice::Communicator> communicator_;
  const bool is_certified_;
};

}  // namespace tendon::ice
